#pragma once

#include <optional>
#include <string>

namespace fpkcheck::problem {

/// What decides the form of a law besides its mean and deviation: keys of case files, of which most
/// laws take none.
struct LawShape {
  /// E[(Y - mean)^3] / deviation^3.
  std::optional<double> skewness = {};
  /// A table of amplitudes (problem/amplitude_table.hpp).
  std::string table = {};
};

}  // namespace fpkcheck::problem
