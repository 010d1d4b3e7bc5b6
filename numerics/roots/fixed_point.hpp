#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>

namespace fpkcheck::numerics {

/// A map x -> f(x) of vectors, which returns nullopt outside the domain of f.
using VectorMap = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& x)>;

struct FixedPointOptions {
  /// Function that returns the norm of a change f(x) - x of the iterate x.
  std::function<double(const Eigen::VectorXd& change)> size;
  double tolerance;  ///< largest size of the change at the fixed point
  int max_evaluations = 60;
};

struct FixedPointResult {
  Eigen::VectorXd x;  ///< last value of f
  /// Norm of the last change f(x) - x of the iterate x; infinite without a value of f
  double change = std::numeric_limits<double>::infinity();
  int evaluations = 0;  ///< number of evaluations of f
  bool converged = false;
};

/// Computes a fixed point x = f(x) by Anderson acceleration (Walker and Ni, SIAM Journal on
/// Numerical Analysis 49 (2011) 1715). With the values f_j and the changes u_j = f_j - x_j of the
/// last evaluations j = 0 .. k, k <= 7, the next argument of the map f is
///
///     f_k - sum_j xi_j (f_{j+1} - f_j),  where xi minimises |u_k - sum_j xi_j (u_{j+1} - u_j)|.
///
/// For a linear map f the first eight Anderson iterations are equivalent to iterations of GMRES. If
/// the next argument is outside the domain of the map f, the iteration starts again from f_k.
FixedPointResult solve_fixed_point(const VectorMap& f, const Eigen::VectorXd& start,
                                   const FixedPointOptions& options);

}  // namespace fpkcheck::numerics
