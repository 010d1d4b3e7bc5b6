#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"

namespace fpkcheck::problem {

/// The uniform law, with constant density on (mean - half_width, mean + half_width) and variance
/// half_width^2 / 3.
struct UniformLaw {
  double mean;
  double half_width;

  static constexpr std::string_view kName = "uniform";
  static constexpr std::string_view kWidthName = "half_width";
  static UniformLaw from_moments(double mean, double deviation) {
    return {mean, deviation * std::numbers::sqrt3};
  }
  double width() const { return half_width; }
  double standard_deviation() const { return half_width / std::numbers::sqrt3; }

  /// E[((Y - mean) / standard_deviation())^n]: 3^(n/2) / (n+1) for even n, 0 for odd n.
  double standardised_moment(int n) const {
    return n % 2 == 0 ? std::pow(3.0, n / 2) / (n + 1) : 0;
  }
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> atoms() const { return {}; }
  std::vector<double> density_breakpoints() const { return {mean - half_width, mean + half_width}; }
  std::complex<double> centred_characteristic_function(double u) const;
  double centred_moment_generating_function(double u) const;
};

}  // namespace fpkcheck::problem
