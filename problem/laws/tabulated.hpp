#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "problem/laws/shape_parameters.hpp"

namespace fpkcheck::problem {

struct AmplitudeTable;

/// The law of a table: Y = mean + scale Z. The law of Z is that of the table, shifted and scaled to
/// mean 0 and standard deviation 1. Z is discrete or has a piecewise linear density. The mirrored
/// law, that of -Y, has a negative scale.
struct TabulatedLaw {
  double mean;
  double scale;
  std::shared_ptr<const AmplitudeTable> standard;  ///< table of the law of Z

  static constexpr std::string_view kName = "tabulated";
  static constexpr std::string_view kWidthName = "scale";
  /// The law of shape.table, shifted and scaled to the given mean and standard deviation.
  /// @throws InputError if the table is missing or invalid
  static TabulatedLaw from_moments(double mean, double deviation, const LawShapeParameters& shape);
  double width() const { return scale; }
  double standard_deviation() const;

  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> atoms() const;
  std::vector<double> density_breakpoints() const;
  /// The law of Z.
  TabulatedLaw standardised() const { return {0, 1, standard}; }
  /// The law of -Y.
  TabulatedLaw mirror_image() const { return {-mean, -scale, standard}; }
};

}  // namespace fpkcheck::problem
