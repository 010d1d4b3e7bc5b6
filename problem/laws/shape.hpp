#pragma once

#include <optional>
#include <string>

namespace fpkcheck::problem {

/// Shape parameters of a law besides its mean and standard deviation, from the case file. Most laws
/// have none.
struct LawShape {
  /// E[(Y - mean)^3] / deviation^3.
  std::optional<double> skewness = {};
  /// A table of amplitudes (problem/amplitude_table.hpp).
  std::string table = {};
};

}  // namespace fpkcheck::problem
