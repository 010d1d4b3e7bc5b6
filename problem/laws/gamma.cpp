#include "problem/laws/gamma.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <cmath>
#include <limits>

#include "base/input_error.hpp"

namespace fpkcheck::problem {
namespace {

constexpr double kDefaultSkewness = 1, kMinSkewness = 0.01, kMaxSkewness = 2;

// The value of the gamma variable G that gives Y = y.
double standardised_variate(const GammaLaw& law, double y) {
  return law.shape() + (y - law.mean) / law.width() * std::sqrt(law.shape());
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

double GammaLaw::width() const { return std::copysign(deviation, skewness); }

double GammaLaw::standardised_moment(int n) const {
  double before = 0, moment = 1;
  for (int i = 0; i < n; ++i) {
    const double next = i * (skewness / 2 * moment + before);
    before = moment;
    moment = next;
  }
  return moment;
}

double GammaLaw::density(double y) const {
  const double g = standardised_variate(*this, y);
  return g >= 0 ? boost::math::gamma_p_derivative(shape(), g) * std::sqrt(shape()) / deviation : 0;
}

double GammaLaw::cumulative_probability(double y) const {
  const double g = std::max(standardised_variate(*this, y), 0.0);
  return skewness > 0 ? boost::math::gamma_p(shape(), g) : boost::math::gamma_q(shape(), g);
}

std::vector<double> GammaLaw::density_breakpoints() const {
  // The probability beyond each end of the break points is 1e-20. Near the end of the support the
  // density is x^(k-1) times a smooth function. A ten-point quadrature rule integrates such a
  // density between x and 3 x.
  constexpr double kBeyond = 1e-20, kFirst = 1e-9, kGrowth = 3;
  const double k = shape(), deviations = std::sqrt(k);
  const double low = boost::math::gamma_p_inv(k, kBeyond);
  std::vector<double> pieces;
  if (low < deviations) pieces.push_back(0);
  double g = std::max(low, kFirst * deviations);
  do {
    pieces.push_back(g);
    g *= kGrowth;
  } while (g < deviations);
  pieces.push_back(boost::math::gamma_q_inv(k, kBeyond));
  for (double& x : pieces) x = mean + width() * (x - k) / deviations;
  if (skewness < 0) std::ranges::reverse(pieces);
  return pieces;
}

std::complex<double> GammaLaw::centred_characteristic_function(double u) const {
  // The result is (1 - ix)^-k exp(-ikx) with x = u deviation skewness/2. The formula below avoids
  // the difference of two large phases.
  const double x = u * deviation * skewness / 2, k = shape();
  return std::polar(std::exp(-k * std::log1p(x * x) / 2), k * (std::atan(x) - x));
}

double GammaLaw::centred_moment_generating_function(double u) const {
  const double x = u * deviation * skewness / 2;
  if (x >= 1) return std::numeric_limits<double>::infinity();
  return std::exp(-shape() * boost::math::log1pmx(-x));
}

double GammaLaw::standardised_quantile(double p, double q) const {
  const double k = shape();
  const double g = p < q ? boost::math::gamma_p_inv(k, p) : boost::math::gamma_q_inv(k, q);
  return (g - k) / std::sqrt(k);
}

}  // namespace fpkcheck::problem
