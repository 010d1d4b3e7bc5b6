#pragma once

#include <string>

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// Bounds of a parameter that is not zero. Beyond them powers of the deviations, of which the
/// solvers form the twelfth and more, leave the range of double precision; a change of the units of
/// time and length brings any problem inside.
inline constexpr double kSmallestMagnitude = 1e-30;
inline constexpr double kLargestMagnitude = 1e30;

/// @param values with the prefix of their names in case files
/// @throws InputError naming the first number, its value and the bounds, that is outside them and
/// not zero
void require_magnitudes(const std::string& prefix, const base::Values& values);

template <class Owner>
void require_magnitudes(const base::Description<Owner>& description, const Owner& owner) {
  require_magnitudes(description.prefix(), description.values(owner));
}

}  // namespace fpkcheck::problem
