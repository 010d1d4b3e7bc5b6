#pragma once

#include <optional>
#include <string>

namespace fpkcheck::problem {

/// Parameters of an amplitude law in addition to its mean and standard deviation, read from the
/// case file.
struct LawShapeParameters {
  /// Skewness E[(Y - mean)^3] / deviation^3 of the amplitude Y; absent for laws without skewness.
  std::optional<double> skewness = {};
  /// A table literal of amplitudes (problem/amplitude_table.hpp); empty for laws without a table.
  std::string table = {};
};

/// An impulse amplitude with positive probability, and the probability of the amplitude.
struct AmplitudeAtom {
  double amplitude;
  double probability;
};

}  // namespace fpkcheck::problem
