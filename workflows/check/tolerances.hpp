#pragma once

#include <cstddef>

namespace fpkcheck::check {

/// Tolerances for the change of a quantity between two runs. docs/checking.md has the measurements
/// behind the numbers.
struct Tolerances {
  /// For deterministic quantities: moments relative, mass and energy residual absolute, densities
  /// relative to their peak, distances in units of the deviation of the variable. Rounding changes
  /// these by up to 6e-11.
  double deterministic = 1e-8;
  /// For simulations: in standard errors of the difference, those of both runs in quadrature.
  double standard_errors = 4;

  /// For the coefficients of a closure, relative: rounding changes small coefficients of the
  /// formulation `moment` by up to 1.5e-7.
  double coefficient() const { return 50 * deterministic; }
  /// For the mean |log10| difference in a decade, absolute: rounding changes that of densities of
  /// 1e-6 of their peak by up to 3e-8.
  double tail() const { return 100 * deterministic; }
  /// Bonferroni-adjusted threshold: the largest of n standard normal numbers exceeds it as rarely
  /// as a single number exceeds `standard_errors`.
  double bonferroni_threshold(std::size_t n) const;
};

/// @throws InputError naming the option whose value is not a positive number
void validate(const Tolerances& tolerances);

}  // namespace fpkcheck::check
