#pragma once

#include <cstddef>

namespace fpkcheck::check {

/// Tolerances for the change of a quantity between two runs. docs/checking.md has the measurements
/// from which the numbers follow.
struct Tolerances {
  /// Tolerance for deterministic quantities: relative for moments, absolute for mass and energy
  /// residual, relative to the peak for densities, in units of the standard deviation of the
  /// variable for distances. Rounding errors change such quantities by up to 6e-11.
  double deterministic = 1e-8;
  /// Tolerance for simulations in standard errors of the difference, which combine the standard
  /// errors of both runs in quadrature.
  double standard_errors = 4;

  /// Relative tolerance for the coefficients of a closure: rounding errors change small
  /// coefficients of the formulation `moment` by up to 1.5e-7.
  double coefficient_tolerance() const { return 50 * deterministic; }
  /// Absolute tolerance for the mean |log10| difference in a decade of the tail: for densities of
  /// 1e-6 of the peak, rounding errors change this difference by up to 3e-8.
  double tail_tolerance() const { return 100 * deterministic; }
  /// The Bonferroni-adjusted threshold for n comparisons: the largest of n standard normal numbers
  /// exceeds this threshold as rarely as a single number exceeds `standard_errors`.
  double bonferroni_threshold(std::size_t n) const;
};

/// @throws InputError naming the option whose value is not a positive number
void validate(const Tolerances& tolerances);

}  // namespace fpkcheck::check
