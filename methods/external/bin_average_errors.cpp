#include "methods/external/bin_average_errors.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace fpkcheck::methods {
namespace {

// Returns the integral over a bin by the trapezoidal rule, as a linear combination of the density
// values at the knots.
BinAverageError trapezoidal_rule(std::span<const double> knots, double lower, double upper) {
  BinAverageError bin{.width = upper - lower, .first = 0, .factors = {}};
  const auto after = std::ranges::upper_bound(knots, lower) - knots.begin();
  bin.first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - 1, 0));
  for (std::size_t k = bin.first; k + 1 < knots.size() && knots[k] < upper; ++k) {
    const double from = std::max(lower, knots[k]), to = std::min(upper, knots[k + 1]);
    const double t = ((from + to) / 2 - knots[k]) / (knots[k + 1] - knots[k]);
    if (bin.factors.empty()) bin.factors = {0};
    bin.factors.back() += (1 - t) * (to - from);
    bin.factors.push_back(t * (to - from));
  }
  return bin;
}

// Replaces the density value v[0] at the first knot by the extrapolation v[1] - (v[2] - v[1]) *
// ratio from the next two knots.
void extrapolate_to_first_knot(BinAverageError& bin, double ratio) {
  if (bin.first > 0) {
    --bin.first;
    return;
  }
  if (bin.factors.empty()) return;
  const double at_first = bin.factors.front();
  bin.factors.erase(bin.factors.begin());
  bin.factors.resize(std::max<std::size_t>(bin.factors.size(), 2));
  bin.factors[0] += at_first * (1 + ratio);
  bin.factors[1] -= at_first * ratio;
}

// Replaces the value at the last knot (index `points`) by extrapolation from two knots.
void extrapolate_to_last_knot(BinAverageError& bin, std::size_t points, double ratio) {
  if (bin.first + bin.factors.size() <= points) return;
  const double at_last = bin.factors.back();
  bin.factors.pop_back();
  while (bin.factors.size() < 2) {
    bin.factors.insert(bin.factors.begin(), 0);
    --bin.first;
  }
  bin.factors.end()[-1] += at_last * (1 + ratio);
  bin.factors.end()[-2] -= at_last * ratio;
}

}  // namespace

double BinAverageError::standard_error() const {
  return std::sqrt(std::inner_product(factors.begin(), factors.end(), factors.begin(), 0.0));
}

std::vector<BinAverageError> compute_bin_average_errors(std::span<const double> knots,
                                                        std::span<const double> errors,
                                                        std::span<const double> edges,
                                                        const WallExtrapolation& extrapolation) {
  const std::size_t last = knots.size() - 1;
  std::vector<BinAverageError> bins;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    BinAverageError bin = trapezoidal_rule(knots, edges[b], edges[b + 1]);
    if (extrapolation.left) {
      extrapolate_to_first_knot(bin, (knots[1] - knots[0]) / (knots[2] - knots[1]));
    }
    if (extrapolation.right) {
      extrapolate_to_last_knot(
          bin, errors.size(),
          (knots[last] - knots[last - 1]) / (knots[last - 1] - knots[last - 2]));
    }
    for (std::size_t k = 0; k < bin.factors.size(); ++k) {
      bin.factors[k] *= errors[bin.first + k] / bin.width;
    }
    bins.push_back(std::move(bin));
  }
  return bins;
}

// The errors of neighbouring bins are correlated, since neighbouring bins share points. The 99 %
// quantile of the L1 sampling error is computed from random samples of the errors at the points, to
// include the correlations between bins.
L1SamplingError l1_sampling_error(std::span<const BinAverageError> bins) {
  constexpr int kReplicates = 1000;
  constexpr std::uint64_t kSeed = 20240501;  // an arbitrary fixed seed for reproducible results
  L1SamplingError result;
  std::size_t points = 0;
  for (const auto& bin : bins) {
    result.expected += std::sqrt(2 / std::numbers::pi) * bin.standard_error() * bin.width;
    points = std::max(points, bin.first + bin.factors.size());
  }
  boost::random::mt19937_64 engine(kSeed);
  boost::random::normal_distribution<double> normal;
  std::vector<double> z(points), distances;
  for (int k = 0; k < kReplicates; ++k) {
    for (double& error : z) error = normal(engine);
    double distance = 0;
    for (const auto& bin : bins) {
      distance += bin.width * std::abs(std::inner_product(
                                  bin.factors.begin(), bin.factors.end(),
                                  z.begin() + static_cast<std::ptrdiff_t>(bin.first), 0.0));
    }
    distances.push_back(distance);
  }
  const auto nth = distances.begin() + kReplicates * 99 / 100;
  std::ranges::nth_element(distances, nth);
  result.quantile_99 = *nth;
  return result;
}

}  // namespace fpkcheck::methods
