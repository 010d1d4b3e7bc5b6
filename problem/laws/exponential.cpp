#include "problem/laws/exponential.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/input_error.hpp"

namespace fpkcheck::problem {
namespace {

constexpr double kSkewness = 2;

}  // namespace

ExponentialLaw ExponentialLaw::from_moments(double mean, double deviation,
                                            const LawShapeParameters& shape) {
  const double skewness = shape.skewness.value_or(kSkewness);
  if (std::abs(skewness) != kSkewness) {
    throw InputError(
        fmt::format("impulse.skewness = {}: an exponential law has skewness 2, or -2 with its tail "
                    "below; take impulse.law = gamma for others",
                    skewness));
  }
  return {mean, std::copysign(deviation, skewness)};
}

double ExponentialLaw::standard_deviation() const { return std::abs(scale); }

double ExponentialLaw::standardised_moment(int n) const {
  double derangements = 1;  // recursion D_n = n D_{n-1} + (-1)^n
  for (int i = 1; i <= n; ++i) derangements = i * derangements + (i % 2 == 0 ? 1 : -1);
  return scale < 0 && n % 2 != 0 ? -derangements : derangements;
}

double ExponentialLaw::density(double y) const {
  const double e = 1 + (y - mean) / scale;
  return e >= 0 ? std::exp(-e) / std::abs(scale) : 0;
}

double ExponentialLaw::cumulative_probability(double y) const {
  const double e = 1 + (y - mean) / scale;  // value of E; increases in y for a positive scale
  if (scale > 0) return e > 0 ? -std::expm1(-e) : 0;
  return e > 0 ? std::exp(-e) : 1;
}

std::vector<double> ExponentialLaw::density_breakpoints() const {
  constexpr double kTailLength = 46;
  const double start = mean - scale, end = start + kTailLength * scale;
  return scale > 0 ? std::vector{start, end} : std::vector{end, start};
}

std::complex<double> ExponentialLaw::centred_characteristic_function(double u) const {
  return std::polar(1.0, -u * scale) / std::complex(1.0, -u * scale);
}

double ExponentialLaw::centred_moment_generating_function(double u) const {
  const double x = u * scale;
  return x < 1 ? std::exp(-x) / (1 - x) : std::numeric_limits<double>::infinity();
}

}  // namespace fpkcheck::problem
