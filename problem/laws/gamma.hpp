#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"
#include "problem/laws/shape.hpp"

namespace fpkcheck::problem {

/// Y = mean + deviation (G - k) / (sqrt(k) sgn skewness), where G has the gamma density
/// x^(k-1) e^-x / Gamma(k), k = 4 / skewness^2. The law is exponential for skewness 2 and nearly
/// gaussian for a small skewness.
struct GammaLaw {
  double mean;
  double deviation;
  double skewness;

  static constexpr std::string_view kName = "gamma";
  static constexpr std::string_view kWidthName = "deviation";
  /// The default skewness is 1.
  /// @throws InputError when |skewness| is outside 0.01 .. 2 (above 2 the density is unbounded)
  static GammaLaw from_moments(double mean, double deviation, const LawShape& shape);
  /// The deviation, times the sign of the skewness.
  double width() const;
  double standard_deviation() const { return deviation; }
  /// The shape parameter k.
  double shape() const { return 4 / (skewness * skewness); }

  /// m_{n+1} = n (skewness/2 m_n + m_{n-1}).
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative(double y) const;
  std::vector<Atom> atoms() const { return {}; }
  /// Break points, closer together near the end of the support, where the density behaves like a
  /// power.
  std::vector<double> density_breakpoints() const;
  std::complex<double> centred_characteristic_function(double u) const;
  /// Infinite for u deviation skewness / 2 >= 1.
  double centred_moment_generating_function(double u) const;
  /// The law of -Y.
  GammaLaw mirrored() const { return {-mean, deviation, -skewness}; }

  /// The standardised quantile (x - k) / sqrt(k), P(G <= x) = p, P(G > x) = q, p + q = 1. Computed
  /// from the smaller of p and q.
  double standardised_quantile(double p, double q) const;
};

}  // namespace fpkcheck::problem
