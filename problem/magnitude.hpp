#pragma once

#include <string>

namespace fpkcheck::problem {

/// Bounds of a parameter that is not zero. Beyond them powers of the deviations, of which the
/// solvers form the twelfth and more, leave the range of double precision; a change of the units of
/// time and length brings any problem inside.
inline constexpr double kSmallestMagnitude = 1e-30;
inline constexpr double kLargestMagnitude = 1e30;

/// @param key as in a case file
/// @throws InputError naming the key, its value and the bounds, when the value is outside them and
/// not zero
void require_magnitude(const std::string& key, double value);

}  // namespace fpkcheck::problem
