#include "problem/magnitude.hpp"

#include <fmt/format.h>

#include <cmath>

#include "problem/input_error.hpp"

namespace fpkcheck::problem {

void require_magnitude(const std::string& key, double value) {
  const double magnitude = std::abs(value);
  if (value == 0 || (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude)) return;
  throw InputError(
      fmt::format("{} = {} (magnitudes must lie within {} .. {}: choose other units of time and "
                  "length)",
                  key, value, kSmallestMagnitude, kLargestMagnitude));
}

}  // namespace fpkcheck::problem
