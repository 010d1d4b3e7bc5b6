#pragma once

#include <complex>
#include <memory>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"
#include "problem/laws/shape.hpp"

namespace fpkcheck::problem {

struct AmplitudeTable;

/// Y = mean + scale Z, where Z has the law of a table, shifted and scaled to mean 0 and deviation
/// 1: atoms, or a piecewise linear density. The mirrored law has a negative scale.
struct TabulatedLaw {
  double mean;
  double scale;
  std::shared_ptr<const AmplitudeTable> standard;  ///< the table of Z

  static constexpr std::string_view kName = "tabulated";
  static constexpr std::string_view kWidthName = "scale";
  /// @throws InputError when the table is missing or invalid
  static TabulatedLaw from_moments(double mean, double deviation, const LawShape& shape);
  double width() const { return scale; }
  double standard_deviation() const;

  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative(double y) const;
  std::vector<Atom> atoms() const;
  std::vector<double> density_breakpoints() const;
  std::complex<double> centred_characteristic_function(double u) const;
  double centred_moment_generating_function(double u) const;
  /// The law of Z.
  TabulatedLaw standardised() const { return {0, 1, standard}; }
  /// The law of -Y.
  TabulatedLaw mirrored() const { return {-mean, -scale, standard}; }
};

}  // namespace fpkcheck::problem
