#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"
#include "problem/laws/shape_parameters.hpp"

namespace fpkcheck::problem {

/// The shifted exponential law: Y = mean + scale (E - 1) with P(E > x) = exp(-x) for x >= 0. The
/// support is y >= mean - scale for a positive scale and y <= mean - scale for a negative scale.
/// The standard deviation is |scale|; the skewness is 2 for a positive scale and -2 for a negative
/// scale.
struct ExponentialLaw {
  double mean;
  double scale;

  static constexpr std::string_view kName = "exponential";
  static constexpr std::string_view kWidthName = "scale";
  /// The exponential law with the given moments; the default skewness is 2.
  /// @throws InputError if the skewness is neither 2 nor -2
  static ExponentialLaw from_moments(double mean, double deviation,
                                     const LawShapeParameters& shape);
  double width() const { return scale; }
  double standard_deviation() const;

  /// E[((Y - mean) / standard_deviation())^n]: the number of derangements of n objects, E[(E -
  /// 1)^n], times the sign of scale^n.
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> atoms() const { return {}; }
  std::vector<double> density_breakpoints() const;
  /// E[exp(iu (Y - mean))] = exp(-iu scale) / (1 - iu scale).
  std::complex<double> centred_characteristic_function(double u) const;
  /// E[exp(u (Y - mean))]; infinite for u scale >= 1.
  double centred_moment_generating_function(double u) const;
  /// The law of -Y.
  ExponentialLaw mirror_image() const { return {-mean, -scale}; }
};

}  // namespace fpkcheck::problem
