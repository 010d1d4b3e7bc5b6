#pragma once

#include <string>

#include "base/options/option_description.hpp"
#include "base/options/parameter_value.hpp"

namespace fpkcheck::problem {

/// Limits of the magnitude of a nonzero parameter. For parameters within the limits, the twelfth
/// powers of standard deviations neither overflow nor underflow in double precision. A change of
/// the units of time and length brings the parameters of any problem within the limits of
/// magnitude.
inline constexpr double kSmallestMagnitude = 1e-30;
inline constexpr double kLargestMagnitude = 1e30;

/// Requires that the magnitude of every nonzero number is within kSmallestMagnitude ..
/// kLargestMagnitude.
/// @param prefix text before the parameter names in error messages, as in case files: "system."
/// @throws InputError that states the limits, and name and value of the first number outside
void require_magnitudes_in_range(const std::string& prefix, const base::Values& values);

template <class Owner>
void require_magnitudes_in_range(const base::OptionsDescription<Owner>& description,
                                 const Owner& owner) {
  require_magnitudes_in_range(description.prefix(), description.values(owner));
}

inline base::AdmissibleRange admissible_restitution_range() {
  return {[](double r) { return r > 0 && r <= 1; }, "above 0 and at most 1"};
}

}  // namespace fpkcheck::problem
