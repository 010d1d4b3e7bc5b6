#pragma once

#include <boost/math/distributions/uniform.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/special_functions/sinhc.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"

namespace fpkcheck::problem {

/// Constant density on (mean - half_width, mean + half_width): variance half_width^2 / 3.
struct UniformLaw {
  double mean;
  double half_width;

  static constexpr std::string_view kName = "uniform";
  static constexpr std::string_view kWidthName = "half_width";
  static UniformLaw with(double mean, double deviation) {
    return {mean, deviation * std::numbers::sqrt3};
  }
  double width() const { return half_width; }
  double standard_deviation() const { return half_width / std::numbers::sqrt3; }

  /// 3^(n/2) / (n+1) for even n.
  double standardised_moment(int n) const {
    return n % 2 == 0 ? std::pow(3.0, n / 2) / (n + 1) : 0;
  }
  double density(double y) const {
    return boost::math::pdf(boost::math::uniform(mean - half_width, mean + half_width), y);
  }
  double cumulative(double y) const {
    return boost::math::cdf(boost::math::uniform(mean - half_width, mean + half_width), y);
  }
  std::vector<Atom> atoms() const { return {}; }
  std::vector<double> smooth_pieces() const { return {mean - half_width, mean + half_width}; }
  std::complex<double> centred_characteristic_function(double u) const {
    return boost::math::sinc_pi(u * half_width);
  }
  double centred_moment_generating_function(double u) const {
    return boost::math::sinhc_pi(u * half_width);
  }
};

}  // namespace fpkcheck::problem
