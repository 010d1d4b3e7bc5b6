#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"
#include "problem/laws/shape.hpp"

namespace fpkcheck::problem {

/// Y = mean + scale (E - 1), P(E > x) = exp(-x): from mean - scale on upwards where the scale is
/// positive, downwards where it is negative. Its deviation is the size of the scale, its skewness 2
/// with the sign of the scale.
struct ExponentialLaw {
  double mean;
  double scale;

  static constexpr std::string_view kName = "exponential";
  static constexpr std::string_view kWidthName = "scale";
  /// @throws InputError where the skewness is given and neither 2 nor -2; 2 unless given
  static ExponentialLaw with(double mean, double deviation, const LawShape& shape);
  double width() const { return scale; }
  double standard_deviation() const;

  /// E[(E - 1)^n], the number of derangements of n, with the sign of scale^n.
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative(double y) const;
  std::vector<Atom> atoms() const { return {}; }
  std::vector<double> smooth_pieces() const;
  /// exp(-iu scale) / (1 - iu scale)
  std::complex<double> centred_characteristic_function(double u) const;
  /// Infinite from u scale = 1 on.
  double centred_moment_generating_function(double u) const;
  /// The law of -Y.
  ExponentialLaw mirrored() const { return {-mean, -scale}; }
};

}  // namespace fpkcheck::problem
