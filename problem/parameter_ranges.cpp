#include "problem/parameter_ranges.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"

namespace fpkcheck::problem {

void require_magnitudes_in_range(const std::string& prefix, const base::Values& values) {
  for (const auto& [name, value] : values) {
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr || *number == 0) continue;
    const double magnitude = std::abs(*number);
    if (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude) continue;
    throw InputError(
        fmt::format("{}{} = {}: magnitudes must lie within {} .. {}; choose other units of time "
                    "and length",
                    prefix, name, *number, kSmallestMagnitude, kLargestMagnitude));
  }
}

}  // namespace fpkcheck::problem
