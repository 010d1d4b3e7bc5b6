#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"
#include "problem/laws/shape.hpp"

namespace fpkcheck::problem {

/// Y = mean + deviation (G - k) / (sqrt(k) sgn skewness), G of the gamma law with density
/// x^(k-1) e^-x / Gamma(k), k = 4 / skewness^2: exponential for the skewness 2, nearly gaussian for
/// a small one.
struct GammaLaw {
  double mean;
  double deviation;
  double skewness;

  static constexpr std::string_view kName = "gamma";
  static constexpr std::string_view kWidthName = "deviation";
  /// @throws InputError where the size of the skewness is not within 0.01 .. 2 (beyond, the density
  /// has no bound); 1 unless given
  static GammaLaw with(double mean, double deviation, const LawShape& shape);
  /// With the sign of the skewness.
  double width() const;
  double standard_deviation() const { return deviation; }
  /// k
  double shape() const { return 4 / (skewness * skewness); }

  /// m_{n+1} = n (skewness/2 m_n + m_{n-1}).
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative(double y) const;
  std::vector<Atom> atoms() const { return {}; }
  /// Finer towards the end of the support, from which the density rises with any power.
  std::vector<double> smooth_pieces() const;
  std::complex<double> centred_characteristic_function(double u) const;
  /// Infinite from u deviation skewness / 2 = 1 on.
  double centred_moment_generating_function(double u) const;
  /// The law of -Y.
  GammaLaw mirrored() const { return {-mean, deviation, -skewness}; }

  /// (x - k) / sqrt(k), P(G <= x) = p, P(G > x) = q; of p and q, whose sum is 1, the smaller one is
  /// looked at.
  double standardised_quantile(double p, double q) const;
};

}  // namespace fpkcheck::problem
