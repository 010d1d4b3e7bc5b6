#pragma once

#include <cstddef>

namespace fpkcheck::check {

/// By how much a figure may move before `check` calls it a change. docs/checking.md holds the
/// measurements behind the numbers.
struct Tolerances {
  /// Of what no chance enters: moments relative, mass and balance of power as they are, densities
  /// relative to their peak, distances in the units of deviations of the variable. Rounding alone
  /// moves these by up to 6e-11.
  double deterministic = 1e-8;
  /// Of a simulation: both runs' standard errors in quadrature.
  double standard_errors = 4;

  /// Of a closure's coefficients, relative: rounding moves small ones of the formulation `moment`
  /// by up to 1.5e-7.
  double coefficient() const { return 50 * deterministic; }
  /// Of mean |log10| differences by decades, absolute: rounding moves those of densities 1e-6 of
  /// their peak by up to 3e-8.
  double tail() const { return 100 * deterministic; }
  /// The deviation that the largest of n independent normal numbers exceeds as rarely as a single
  /// one exceeds `standard_errors`.
  double of_the_largest(std::size_t n) const;
};

/// @throws InputError naming the option that is no positive number
void validate(const Tolerances& tolerances);

}  // namespace fpkcheck::check
