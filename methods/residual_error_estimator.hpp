#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::backward {
class DensityErrorEstimator;
}  // namespace fpkcheck::backward

namespace fpkcheck::methods {

/// Residual-based estimator of the errors of approximate stationary densities of one problem. The
/// estimator solves the backward equations in wall coordinates at its first use, once for all
/// threads.
class ResidualErrorEstimator {
 public:
  /// @param problem problem in physical or in wall coordinates
  explicit ResidualErrorEstimator(const problem::Problem& problem);
  ResidualErrorEstimator(ResidualErrorEstimator&&) noexcept;
  ~ResidualErrorEstimator();

  /// Returns the residual-based error estimator for densities in wall coordinates; null if the
  /// backward equations cannot be solved, or if residuals_unsupported_reason() of the library
  /// `backward` returns a reason. Several threads may call density_error_estimator() at the same
  /// time.
  const backward::DensityErrorEstimator* density_error_estimator() const;
  const problem::WallFrame& wall_coordinates() const;
  /// Returns why the residual-based estimator does not support the problem; an empty text for a
  /// supported problem.
  const std::string& unsupported_reason() const;

 private:
  struct LazyFit;
  std::unique_ptr<LazyFit> fit_;
};

std::vector<ResidualErrorEstimator> make_error_estimators(
    const std::vector<problem::Problem>& problems);

/// Sets the error estimate of a solution with a density by the dual-weighted residual method
/// (backward/residual/density_error_estimator.hpp). The error estimate refers to the exact density
/// of the full problem, even if the method solves an approximate equation. The status `ok` of a
/// solution becomes `inaccurate` if the L1 error estimate is missing or exceeds `accuracy`.
/// @param accuracy largest admissible L1 error of p(y) and of p(y')
/// @param coordinates coordinates of the density of the solution; by default physical coordinates
/// @param reason_prefix first words of the reason for the status `inaccurate`
void set_residual_error_estimate(
    const ResidualErrorEstimator& estimator, double accuracy, transform::Solution& solution,
    const problem::WallFrame& coordinates = {},
    std::string_view reason_prefix = "the density meets its equations, but ");

}  // namespace fpkcheck::methods
