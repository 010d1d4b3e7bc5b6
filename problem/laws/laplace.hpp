#pragma once

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"

namespace fpkcheck::problem {

/// The Laplace law, with density exp(-|y - mean| / scale) / (2 scale) and variance 2 scale^2.
struct LaplaceLaw {
  double mean;
  double scale;

  static constexpr std::string_view kName = "laplace";
  static constexpr std::string_view kWidthName = "scale";
  static LaplaceLaw from_moments(double mean, double deviation) {
    return {mean, deviation / std::numbers::sqrt2};
  }
  double width() const { return scale; }
  double standard_deviation() const { return std::numbers::sqrt2 * scale; }

  /// E[((Y - mean) / standard_deviation())^n]: n! / 2^(n/2) for even n, 0 for odd n.
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> atoms() const { return {}; }
  std::vector<double> density_breakpoints() const {
    return {mean - 42 * scale, mean, mean + 42 * scale};
  }
  std::complex<double> centred_characteristic_function(double u) const {
    return 1 / (1 + u * u * scale * scale);
  }
  double centred_moment_generating_function(double u) const {
    const double ub = std::abs(u) * scale;
    return ub < 1 ? 1 / (1 - ub * ub) : std::numeric_limits<double>::infinity();
  }
};

}  // namespace fpkcheck::problem
