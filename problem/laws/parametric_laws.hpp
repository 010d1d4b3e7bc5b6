#pragma once

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "problem/laws/shape_parameters.hpp"

namespace fpkcheck::problem {

struct GaussianLaw {
  double mean;
  double deviation;

  static constexpr std::string_view kName = "gaussian";
  static constexpr std::string_view kWidthName = "deviation";
  static GaussianLaw from_moments(double mean, double deviation) { return {mean, deviation}; }
  double width_parameter() const { return deviation; }
  double standard_deviation() const { return deviation; }

  /// Returns the moment E[((Y - mean) / deviation)^n] of the Gaussian law, which is (n-1)!! for
  /// even n and 0 for odd n.
  double standardised_amplitude_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> amplitude_atoms() const { return {}; }
  std::vector<double> amplitude_density_breakpoints() const {
    return {mean - 9 * deviation, mean + 9 * deviation};
  }
};

/// The Laplace law, with density exp(-|y - mean| / scale) / (2 scale) and variance 2 scale^2.
struct LaplaceLaw {
  double mean;
  double scale;

  static constexpr std::string_view kName = "laplace";
  static constexpr std::string_view kWidthName = "scale";
  static LaplaceLaw from_moments(double mean, double deviation) {
    return {mean, deviation / std::numbers::sqrt2};
  }
  double width_parameter() const { return scale; }
  double standard_deviation() const { return std::numbers::sqrt2 * scale; }

  /// Returns the moment E[((Y - mean) / standard_deviation())^n] of the Laplace law, which is n! /
  /// 2^(n/2) for even n and 0 for odd n.
  double standardised_amplitude_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> amplitude_atoms() const { return {}; }
  std::vector<double> amplitude_density_breakpoints() const {
    return {mean - 42 * scale, mean, mean + 42 * scale};
  }
};

/// The two-point law of Y = mean - deviation or Y = mean + deviation, each with probability 1/2.
struct TwoPointLaw {
  double mean;
  double deviation;

  static constexpr std::string_view kName = "two_point";
  static constexpr std::string_view kWidthName = "deviation";
  static TwoPointLaw from_moments(double mean, double deviation) { return {mean, deviation}; }
  double width_parameter() const { return deviation; }
  double standard_deviation() const { return deviation; }

  double standardised_amplitude_moment(int n) const { return n % 2 == 0 ? 1 : 0; }
  double density(double) const { return 0; }
  double cumulative_probability(double y) const {
    return y < mean - deviation ? 0 : y < mean + deviation ? 0.5 : 1;
  }
  std::vector<AmplitudeAtom> amplitude_atoms() const {
    return {{mean - deviation, 0.5}, {mean + deviation, 0.5}};
  }
  std::vector<double> amplitude_density_breakpoints() const { return {}; }
};

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
  double width_parameter() const { return half_width; }
  double standard_deviation() const { return half_width / std::numbers::sqrt3; }

  /// Returns the moment E[((Y - mean) / standard_deviation())^n] of the uniform law, which is
  /// 3^(n/2) / (n+1) for even n and 0 for odd n.
  double standardised_amplitude_moment(int n) const {
    return n % 2 == 0 ? std::pow(3.0, n / 2) / (n + 1) : 0;
  }
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> amplitude_atoms() const { return {}; }
  std::vector<double> amplitude_density_breakpoints() const {
    return {mean - half_width, mean + half_width};
  }
};

/// The shifted exponential law of Y = mean + scale (E - 1), where P(E > x) = exp(-x) for x >= 0.
/// The support of the exponential law is y >= mean - scale for a positive scale and y <= mean -
/// scale for a negative scale. The exponential law has the standard deviation |scale| and the
/// skewness 2 for a positive scale, -2 for a negative scale.
struct ExponentialLaw {
  double mean;
  double scale;

  static constexpr std::string_view kName = "exponential";
  static constexpr std::string_view kWidthName = "scale";
  /// Returns the exponential law with the given mean, standard deviation and skewness (default 2).
  /// @throws InputError if the skewness is neither 2 nor -2
  static ExponentialLaw from_moments(double mean, double deviation,
                                     const LawShapeParameters& shape);
  double width_parameter() const { return scale; }
  double standard_deviation() const;

  /// Returns the moment E[((Y - mean) / standard_deviation())^n] of the exponential law, the number
  /// of derangements of n objects times the sign of scale^n.
  double standardised_amplitude_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> amplitude_atoms() const { return {}; }
  std::vector<double> amplitude_density_breakpoints() const;
  ExponentialLaw with_negated_amplitudes() const { return {-mean, -scale}; }
};

/// The shifted gamma law of Y = mean + deviation (G - k) / (sqrt(k) sgn skewness), where G has the
/// gamma density x^(k-1) e^-x / Gamma(k) with k = 4 / skewness^2. For skewness 2 the gamma law is
/// exponential, and for a small skewness nearly Gaussian.
struct GammaLaw {
  double mean;
  double deviation;
  double skewness;

  static constexpr std::string_view kName = "gamma";
  static constexpr std::string_view kWidthName = "deviation";
  /// Returns the gamma law with the given mean, standard deviation and skewness (default 1).
  /// @throws InputError if the absolute value of the skewness is outside 0.01 .. 2 (above 2 the
  /// gamma density is unbounded)
  static GammaLaw from_moments(double mean, double deviation, const LawShapeParameters& shape);
  /// Returns the signed width, the standard deviation times the sign of the skewness.
  double width_parameter() const;
  double standard_deviation() const { return deviation; }
  double gamma_shape() const { return 4 / (skewness * skewness); }

  /// Returns the moment m_n = E[((Y - mean) / deviation)^n] of the gamma law, by the recursion
  ///
  ///     m_{n+1} = n (skewness/2 m_n + m_{n-1}).
  double standardised_amplitude_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> amplitude_atoms() const { return {}; }
  /// Returns break points for the quadrature of the gamma density, densest near the finite end of
  /// the support, where the gamma density behaves like a power of the distance from the end.
  std::vector<double> amplitude_density_breakpoints() const;
  GammaLaw with_negated_amplitudes() const { return {-mean, deviation, -skewness}; }

  /// Returns the standardised quantile (x - k) / sqrt(k) of the gamma density, where P(G <= x) = p
  /// and P(G > x) = q. The quantile is computed from the smaller of the probabilities p and q, to
  /// avoid cancellation.
  /// @pre p + q = 1
  double standardised_quantile(double p, double q) const;
};

}  // namespace fpkcheck::problem
