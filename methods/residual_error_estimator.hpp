#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::backward {
class DensityResiduals;
}  // namespace fpkcheck::backward

namespace fpkcheck::methods {

/// Residual-based estimator of the errors of densities of one problem. The backward equations are
/// solved in wall coordinates on first use, once for all threads.
class ResidualErrorEstimator {
 public:
  /// @param problem in physical or in wall coordinates
  explicit ResidualErrorEstimator(const problem::Problem& problem);
  ResidualErrorEstimator(ResidualErrorEstimator&&) noexcept;
  ~ResidualErrorEstimator();

  /// The estimator of densities in wall coordinates. Null where its fit breaks down or the problem
  /// is unsupported (backward::residuals_unsupported_reason). May be called from several threads.
  const backward::DensityResiduals* get() const;
  /// The wall coordinates of the problem.
  const problem::Frame& frame() const;
  /// Why the problem is unsupported, in one phrase; empty if supported.
  const std::string& unsupported_reason() const;

 private:
  struct LazyFit;
  std::unique_ptr<LazyFit> fit_;
};

/// The estimators of the problems, in the same order.
std::vector<ResidualErrorEstimator> make_error_estimators(
    const std::vector<problem::Problem>& problems);

/// Sets the error estimate of a solution with a density by the dual-weighted residual method
/// (backward/residual/density_residuals.hpp). The error is that against the full problem, whichever
/// equation the method solves. An `ok` solution becomes `inaccurate` if its estimate exceeds
/// `accuracy` in L1, or if no estimate exists.
/// @param accuracy largest admissible L1 error of p(y) and of p(y')
/// @param coordinates of the solution's density; the physical ones by default
/// @param reason_prefix first words of the reason for an estimate above `accuracy`
void set_residual_error_estimate(
    const ResidualErrorEstimator& estimator, double accuracy, transform::Solution& solution,
    const problem::Frame& coordinates = {},
    std::string_view reason_prefix = "the density meets its equations, but ");

}  // namespace fpkcheck::methods
