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

/// Residual-based estimator of the errors of densities that approximate the stationary density of
/// one problem. The backward equations are solved in wall coordinates on first use, once for all
/// threads.
class ResidualErrorEstimator {
 public:
  /// @param problem in physical or in wall coordinates
  explicit ResidualErrorEstimator(const problem::Problem& problem);
  ResidualErrorEstimator(ResidualErrorEstimator&&) noexcept;
  ~ResidualErrorEstimator();

  /// The estimator for densities in wall coordinates. Null if the solution of the backward
  /// equations breaks down or the problem is unsupported (backward::residuals_unsupported_reason).
  /// Several threads may call this function.
  const backward::DensityResiduals* density_residuals() const;
  /// The wall coordinates of the problem.
  const problem::Frame& wall_coordinates() const;
  /// The reason why the problem is unsupported, in one phrase; empty if the problem is supported.
  const std::string& unsupported_reason() const;

 private:
  struct LazyFit;
  std::unique_ptr<LazyFit> fit_;
};

/// One residual-based error estimator for each problem, in the same order.
std::vector<ResidualErrorEstimator> make_error_estimators(
    const std::vector<problem::Problem>& problems);

/// Sets the error estimate of a solution with a density by the dual-weighted residual method
/// (backward/residual/density_residuals.hpp). The estimated error is the distance from the solution
/// of the full problem, also if the method solves another equation. An `ok` solution becomes
/// `inaccurate` if the L1 error estimate exceeds `accuracy`, or if there is no estimate.
/// @param accuracy largest admissible L1 error of p(y) and of p(y')
/// @param coordinates coordinates of the density of the solution; by default physical coordinates
/// @param reason_prefix first words of the reason for the status `inaccurate`
void set_residual_error_estimate(
    const ResidualErrorEstimator& estimator, double accuracy, transform::Solution& solution,
    const problem::Frame& coordinates = {},
    std::string_view reason_prefix = "the density meets its equations, but ");

}  // namespace fpkcheck::methods
