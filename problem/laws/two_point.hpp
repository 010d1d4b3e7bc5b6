#pragma once

#include <cmath>
#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"

namespace fpkcheck::problem {

/// The two-point law: Y = mean - deviation or Y = mean + deviation, each with probability 1/2.
struct TwoPointLaw {
  double mean;
  double deviation;

  static constexpr std::string_view kName = "two_point";
  static constexpr std::string_view kWidthName = "deviation";
  static TwoPointLaw from_moments(double mean, double deviation) { return {mean, deviation}; }
  double width() const { return deviation; }
  double standard_deviation() const { return deviation; }

  double standardised_moment(int n) const { return n % 2 == 0 ? 1 : 0; }
  double density(double) const { return 0; }
  double cumulative_probability(double y) const {
    return y < mean - deviation ? 0 : y < mean + deviation ? 0.5 : 1;
  }
  std::vector<AmplitudeAtom> atoms() const {
    return {{mean - deviation, 0.5}, {mean + deviation, 0.5}};
  }
  std::vector<double> density_breakpoints() const { return {}; }
  std::complex<double> centred_characteristic_function(double u) const {
    return std::cos(u * deviation);
  }
  double centred_moment_generating_function(double u) const { return std::cosh(u * deviation); }
};

}  // namespace fpkcheck::problem
