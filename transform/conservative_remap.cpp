#include "transform/conservative_remap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "numerics/chebyshev_interpolation.hpp"

namespace fpkcheck::transform {
namespace {

constexpr std::ptrdiff_t kInterpolationPoints =
    8;  // 8 interpolation points give polynomials of degree 7
// Tolerated overshoot of the interpolated cumulative distribution, relative to the total mass. The
// largest overshoot is 2e-7 for the densities of the regression baselines, and 1e-2 at a spike of
// the density. With kOvershootTolerance the masses of smooth densities are not clipped, and the
// remapping of smooth densities is linear in the masses.
constexpr double kOvershootTolerance = 1e-6;

}  // namespace

// Returns the weights of the bin masses in the Lagrange interpolation of the cumulative
// distribution at x, minus the weight 1 of all bins before the bin of x.
ConservativeRemap::InterpolationStencil ConservativeRemap::cumulative_interpolation_stencil(
    std::span<const double> edges, double x) {
  const auto above = std::ranges::lower_bound(edges, x);
  if (above == edges.end()) return {edges.size() - 1, 0, {}};
  const auto k = above - edges.begin();
  if (*above == x || k == 0) return {static_cast<std::size_t>(k), 0, {}};

  // The interpolation stencil is chosen from the bin edges with the indices begin .. end - 1. If
  // one bin edge is at 0, all edges of the stencil have the sign of x or are 0.
  std::ptrdiff_t begin = 0, end = std::ssize(edges);
  if (const auto zero = std::ranges::lower_bound(edges, 0.0); zero != edges.end() && *zero == 0) {
    if (x > 0) begin = zero - edges.begin();
    if (x < 0) end = zero - edges.begin() + 1;
  }
  const auto points = std::min(kInterpolationPoints, end - begin);
  const auto first = std::clamp(k - points / 2, begin, end - points);

  const std::vector<double> lagrange = numerics::lagrange_weights(
      edges.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(points)), x);
  // The cumulative distribution at a bin edge is the mass of all bins before the edge. From the
  // cumulative distribution, the masses of all bins before bin k - 1, the bin of x, are subtracted.
  InterpolationStencil result{static_cast<std::size_t>(k - 1), static_cast<std::size_t>(first),
                              std::vector<double>(static_cast<std::size_t>(points - 1))};
  double sum = 0;
  for (auto a = points - 1; a > 0; --a) {
    sum += lagrange[a];
    result.weights[a - 1] = first + a - 1 < k - 1 ? sum - 1 : sum;
  }
  return result;
}

ConservativeRemap::ConservativeRemap(std::span<const double> source,
                                     std::span<const double> target) {
  for (const double edge : target) edges_.push_back(cumulative_interpolation_stencil(source, edge));
}

std::vector<double> ConservativeRemap::operator()(std::span<const double> masses) const {
  double overshoot_tolerance =
      kOvershootTolerance * std::accumulate(masses.begin(), masses.end(), 0.0);
  if (std::ranges::any_of(masses, [](double mass) { return mass < 0; })) {
    overshoot_tolerance = std::numeric_limits<double>::infinity();
  }
  std::vector<double> result;
  const InterpolationStencil* before = nullptr;
  double within_before = 0;  // mass in the source bin of the previous target edge, below this edge
  for (const InterpolationStencil& edge : edges_) {
    const bool same_bin = before != nullptr && before->bin == edge.bin;
    double within = 0;
    if (!edge.weights.empty()) {
      for (std::size_t k = 0; k < edge.weights.size(); ++k) {
        within += edge.weights[k] * masses[edge.first + k];
      }
      const double least = same_bin ? within_before : 0;
      const double monotone = std::clamp(within, least, std::max(least, masses[edge.bin]));
      if (std::abs(within - monotone) > overshoot_tolerance) within = monotone;
    }
    if (before != nullptr) {
      double mass = within - (same_bin ? within_before : 0);
      if (!same_bin) {
        mass += masses[before->bin] - within_before;
        for (std::size_t bin = before->bin + 1; bin < edge.bin; ++bin) mass += masses[bin];
      }
      result.push_back(mass);
    }
    before = &edge;
    within_before = within;
  }
  return result;
}

}  // namespace fpkcheck::transform
