#pragma once

#include <cmath>
#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"

namespace fpkcheck::problem {

/// The Gaussian law N(mean, deviation^2).
struct GaussianLaw {
  double mean;
  double deviation;

  static constexpr std::string_view kName = "gaussian";
  static constexpr std::string_view kWidthName = "deviation";
  static GaussianLaw from_moments(double mean, double deviation) { return {mean, deviation}; }
  double width() const { return deviation; }
  double standard_deviation() const { return deviation; }

  /// E[((Y - mean) / deviation)^n]: (n-1)!! for even n, 0 for odd n.
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> atoms() const { return {}; }
  std::vector<double> density_breakpoints() const {
    return {mean - 9 * deviation, mean + 9 * deviation};
  }
  /// The characteristic function of Y - mean, E[exp(iu (Y - mean))].
  std::complex<double> centred_characteristic_function(double u) const {
    return std::exp(-u * u * deviation * deviation / 2);
  }
  /// The moment generating function of Y - mean, E[exp(u (Y - mean))].
  double centred_moment_generating_function(double u) const {
    return std::exp(u * u * deviation * deviation / 2);
  }
};

}  // namespace fpkcheck::problem
