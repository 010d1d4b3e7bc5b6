#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "problem/laws/shape_parameters.hpp"

namespace fpkcheck::problem {

struct AmplitudeTable;

/// The law of the amplitude Y = mean + scale Z, where Z is the amplitude of a table, standardised
/// to mean 0 and standard deviation 1. A negative scale mirrors the tabulated amplitude law.
struct TabulatedLaw {
  double mean;
  double scale;
  /// Amplitude table of the standardised amplitude Z.
  std::shared_ptr<const AmplitudeTable> standard;

  static constexpr std::string_view kName = "tabulated";
  static constexpr std::string_view kWidthName = "scale";
  /// Returns the law of the table `shape.table`, scaled to the given mean and standard deviation.
  /// @throws InputError if the amplitude table is missing or invalid
  static TabulatedLaw from_moments(double mean, double deviation, const LawShapeParameters& shape);
  double width_parameter() const { return scale; }
  double standard_deviation() const;

  double standardised_amplitude_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> amplitude_atoms() const;
  std::vector<double> amplitude_density_breakpoints() const;
  TabulatedLaw standardised() const { return {0, 1, standard}; }
  TabulatedLaw with_negated_amplitudes() const { return {-mean, -scale, standard}; }
};

}  // namespace fpkcheck::problem
