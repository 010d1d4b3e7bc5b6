#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "numerics/linear_algebra/factorisations.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::numerics {

/// Equations R(a) = 0 for solve_by_newton(), with a Jacobian of central differences. Unknowns and
/// residuals must be of the order of 1.
/// @tparam Residuals function that returns R(a), as a vector of the size of a
template <class Residuals>
class EquationsWithDifferenceJacobian {
 public:
  struct Iterate {
    Eigen::VectorXd a;  ///< unknowns
    double size;        ///< norm of the residuals
    Eigen::VectorXd residuals;
  };
  struct NewtonStep {
    Eigen::VectorXd change;
  };

  explicit EquationsWithDifferenceJacobian(Residuals residuals)
      : residuals_at_(std::move(residuals)) {}

  Eigen::MatrixXd jacobian_at(const Eigen::VectorXd& unknowns) const {
    // Cube root of the rounding unit: truncation and rounding errors of the difference are then
    // equal.
    constexpr double kDifference = 6e-6;
    const Eigen::Index n = unknowns.size();
    Eigen::MatrixXd jacobian(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::VectorXd change = kDifference * Eigen::VectorXd::Unit(n, k);
      jacobian.col(k) =
          (residuals_at_(unknowns + change) - residuals_at_(unknowns - change)) / (2 * kDifference);
    }
    return jacobian;
  }

  Iterate at(const Eigen::VectorXd& unknowns) const {
    Iterate iterate{.a = unknowns, .size = 0, .residuals = residuals_at_(unknowns)};
    iterate.size = iterate.residuals.norm();
    return iterate;
  }

  NewtonStep step(const Iterate& iterate) const {
    return {.change = -LuFactors(jacobian_at(iterate.a)).solve(iterate.residuals)};
  }

  /// Returns the largest of the fractions 1, 1/2, 1/4, .. for which the residuals decrease; the
  /// change of the unknowns is at most 1.
  double step_fraction(const Iterate& iterate, const NewtonStep& step) const {
    constexpr double kLongestStep = 1, kShortestFraction = 1e-3;
    const double first = std::min(1.0, kLongestStep / step.change.norm());
    return halve_step_until_accepted(first, kShortestFraction, [&](double fraction) {
      return residuals_at_(iterate.a + fraction * step.change).norm() < iterate.size;
    });
  }

 private:
  Residuals residuals_at_;
};

}  // namespace fpkcheck::numerics
