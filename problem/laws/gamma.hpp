#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "problem/laws/atom.hpp"
#include "problem/laws/shape_parameters.hpp"

namespace fpkcheck::problem {

/// The shifted gamma law: Y = mean + deviation (G - k) / (sqrt(k) sgn skewness), where G has the
/// gamma density x^(k-1) e^-x / Gamma(k) with k = 4 / skewness^2. For skewness 2 the law is
/// exponential; for a small skewness the law is nearly Gaussian.
struct GammaLaw {
  double mean;
  double deviation;
  double skewness;

  static constexpr std::string_view kName = "gamma";
  static constexpr std::string_view kWidthName = "deviation";
  /// The gamma law with the given moments; the default skewness is 1.
  /// @throws InputError if |skewness| is outside 0.01 .. 2 (above 2 the density is unbounded)
  static GammaLaw from_moments(double mean, double deviation, const LawShapeParameters& shape);
  /// The width parameter: the standard deviation times the sign of the skewness.
  double width() const;
  double standard_deviation() const { return deviation; }
  /// The shape parameter k of the gamma density.
  double shape() const { return 4 / (skewness * skewness); }

  /// The moment m_n = E[((Y - mean) / deviation)^n], by the recursion m_{n+1} = n (skewness/2 m_n +
  /// m_{n-1}).
  double standardised_moment(int n) const;
  double density(double y) const;
  double cumulative_probability(double y) const;
  std::vector<AmplitudeAtom> atoms() const { return {}; }
  /// Break points of quadrature. The break points are closer together near the finite end of the
  /// support, where the density behaves like a power of the distance to the end.
  std::vector<double> density_breakpoints() const;
  std::complex<double> centred_characteristic_function(double u) const;
  /// E[exp(u (Y - mean))]; infinite for u deviation skewness / 2 >= 1.
  double centred_moment_generating_function(double u) const;
  /// The law of -Y.
  GammaLaw mirror_image() const { return {-mean, deviation, -skewness}; }

  /// The standardised quantile (x - k) / sqrt(k) of the gamma density, where P(G <= x) = p and P(G
  /// > x) = q. The quantile is computed from the smaller of p and q. @pre p + q = 1
  double standardised_quantile(double p, double q) const;
};

}  // namespace fpkcheck::problem
