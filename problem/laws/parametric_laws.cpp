#include "problem/laws/parametric_laws.hpp"

#include <fmt/format.h>
#include <boost/math/distributions/laplace.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/special_functions/factorials.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/input_error.hpp"
#include "numerics/statistics.hpp"

namespace fpkcheck::problem {

double GaussianLaw::standardised_amplitude_moment(int n) const {
  if (n % 2 != 0) return 0;
  return n == 0 ? 1 : boost::math::double_factorial<double>(static_cast<unsigned>(n - 1));
}

double GaussianLaw::density(double y) const {
  return boost::math::pdf(boost::math::normal(mean, deviation), y);
}

double GaussianLaw::cumulative_probability(double y) const {
  return numerics::normal_probability((y - mean) / deviation);
}

double LaplaceLaw::standardised_amplitude_moment(int n) const {
  if (n % 2 != 0) return 0;
  return boost::math::factorial<double>(static_cast<unsigned>(n)) / std::pow(2.0, n / 2);
}

double LaplaceLaw::density(double y) const {
  return boost::math::pdf(boost::math::laplace(mean, scale), y);
}

double LaplaceLaw::cumulative_probability(double y) const {
  return boost::math::cdf(boost::math::laplace(mean, scale), y);
}

double UniformLaw::density(double y) const {
  return boost::math::pdf(boost::math::uniform(mean - half_width, mean + half_width), y);
}

double UniformLaw::cumulative_probability(double y) const {
  return boost::math::cdf(boost::math::uniform(mean - half_width, mean + half_width), y);
}

namespace {

constexpr double kExponentialSkewness = 2;

}  // namespace

ExponentialLaw ExponentialLaw::from_moments(double mean, double deviation,
                                            const LawShapeParameters& shape) {
  const double skewness = shape.skewness.value_or(kExponentialSkewness);
  if (std::abs(skewness) != kExponentialSkewness) {
    throw InputError(
        fmt::format("impulse.skewness = {}: an exponential law has skewness 2, or -2 with its tail "
                    "below; take impulse.law = gamma for others",
                    skewness));
  }
  return {mean, std::copysign(deviation, skewness)};
}

double ExponentialLaw::standard_deviation() const { return std::abs(scale); }

double ExponentialLaw::standardised_amplitude_moment(int n) const {
  // The number D_n of derangements of n objects satisfies the recursion D_n = n D_{n-1} + (-1)^n.
  double derangements = 1;
  for (int i = 1; i <= n; ++i) derangements = i * derangements + (i % 2 == 0 ? 1 : -1);
  return scale < 0 && n % 2 != 0 ? -derangements : derangements;
}

double ExponentialLaw::density(double y) const {
  const double e = 1 + (y - mean) / scale;
  return e >= 0 ? std::exp(-e) / std::abs(scale) : 0;
}

double ExponentialLaw::cumulative_probability(double y) const {
  const double e = 1 + (y - mean) / scale;  // value of the exponential variable E
  if (scale > 0) return e > 0 ? -std::expm1(-e) : 0;
  return e > 0 ? std::exp(-e) : 1;
}

std::vector<double> ExponentialLaw::amplitude_density_breakpoints() const {
  constexpr double kTailLength = 46;
  const double start = mean - scale, end = start + kTailLength * scale;
  return scale > 0 ? std::vector{start, end} : std::vector{end, start};
}

namespace {

constexpr double kDefaultSkewness = 1, kMinSkewness = 0.01, kMaxSkewness = 2;

// Boost's default policy computes in long double, which takes ten times the time of double;
// quadrature rules evaluate the density of the gamma law millions of times.
using DoublePrecision = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

// Returns the value of the gamma variable G that belongs to the amplitude Y = y.
double gamma_variate_of_amplitude(const GammaLaw& law, double y) {
  return law.gamma_shape() + (y - law.mean) / law.width_parameter() * std::sqrt(law.gamma_shape());
}

}  // namespace

GammaLaw GammaLaw::from_moments(double mean, double deviation, const LawShapeParameters& shape) {
  const double skewness = shape.skewness.value_or(kDefaultSkewness), size = std::abs(skewness);
  if (!(size >= kMinSkewness && size <= kMaxSkewness)) {
    throw InputError(
        fmt::format("impulse.skewness = {}: a gamma law needs a magnitude within {} .. {}, above "
                    "which the density is unbounded; for smaller values take gaussian",
                    skewness, kMinSkewness, kMaxSkewness));
  }
  return {mean, deviation, skewness};
}

double GammaLaw::width_parameter() const { return std::copysign(deviation, skewness); }

double GammaLaw::standardised_amplitude_moment(int n) const {
  double before = 0, moment = 1;
  for (int i = 0; i < n; ++i) {
    const double next = i * (skewness / 2 * moment + before);
    before = moment;
    moment = next;
  }
  return moment;
}

double GammaLaw::density(double y) const {
  const double g = gamma_variate_of_amplitude(*this, y);
  if (g < 0) return 0;
  return boost::math::gamma_p_derivative(gamma_shape(), g, DoublePrecision()) *
         std::sqrt(gamma_shape()) / deviation;
}

double GammaLaw::cumulative_probability(double y) const {
  const double g = std::max(gamma_variate_of_amplitude(*this, y), 0.0);
  return skewness > 0 ? boost::math::gamma_p(gamma_shape(), g, DoublePrecision())
                      : boost::math::gamma_q(gamma_shape(), g, DoublePrecision());
}

std::vector<double> GammaLaw::amplitude_density_breakpoints() const {
  // The probability of amplitudes below the first break point, and of amplitudes above the last
  // break point, is 1e-20. Near the finite end x = 0 of the support the gamma density is x^(k-1)
  // times a smooth function, which a ten-point Gauss rule integrates accurately between x and 3 x.
  constexpr double kBeyond = 1e-20, kFirst = 1e-9, kGrowth = 3;
  const double k = gamma_shape(), deviations = std::sqrt(k);
  const double low = boost::math::gamma_p_inv(k, kBeyond);
  std::vector<double> pieces;
  if (low < deviations) pieces.push_back(0);
  double g = std::max(low, kFirst * deviations);
  do {
    pieces.push_back(g);
    g *= kGrowth;
  } while (g < deviations);
  pieces.push_back(boost::math::gamma_q_inv(k, kBeyond));
  for (double& x : pieces) x = mean + width_parameter() * (x - k) / deviations;
  if (skewness < 0) std::ranges::reverse(pieces);
  return pieces;
}

double GammaLaw::standardised_quantile(double p, double q) const {
  assert(std::abs(p + q - 1) < 1e-12);
  const double k = gamma_shape();
  const double g = p < q ? boost::math::gamma_p_inv(k, p) : boost::math::gamma_q_inv(k, q);
  return (g - k) / std::sqrt(k);
}

}  // namespace fpkcheck::problem
