#pragma once

#include <string>

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// Bounds of the magnitude of a nonzero parameter. Outside, powers of the deviations (solvers form
/// the twelfth and higher) exceed the range of double precision. A change of the units of time and
/// length brings any problem into these bounds.
inline constexpr double kSmallestMagnitude = 1e-30;
inline constexpr double kLargestMagnitude = 1e30;

/// @param prefix of the names in case files
/// @throws InputError naming the first nonzero number outside the bounds, its value and the bounds
void require_magnitudes(const std::string& prefix, const base::Values& values);

template <class Owner>
void require_magnitudes(const base::Description<Owner>& description, const Owner& owner) {
  require_magnitudes(description.prefix(), description.values(owner));
}

}  // namespace fpkcheck::problem
