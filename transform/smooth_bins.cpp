#include "transform/smooth_bins.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "transform/conservative_remap.hpp"

namespace fpkcheck::transform {
namespace {

constexpr int kSupportHalfWidth =
    2;  // half-width of the support of the B-spline M, in units of the spacing
// Weights of Boole's rule on four intervals.
constexpr int kBooleIntervals = 4;
constexpr double kBoole[] = {7.0 / 90, 32.0 / 90, 12.0 / 90, 32.0 / 90, 7.0 / 90};

double cubic_spline_slope(double t) {
  const double u = std::abs(t), outer = std::max(0.0, 2 - u), inner = std::max(0.0, 1 - u);
  return std::copysign(1.0, t) * (12 * inner * inner - 3 * outer * outer) / 6;
}

/// Returns increasing points in the support of the smooth bins, between which the integrand F M' is
/// smooth: the knots of the B-splines M, the midpoints between knots, and the edges of the sharp
/// bins.
std::vector<double> smooth_segment_ends(const SmoothBins& bins, const std::vector<double>& edges) {
  const double begin = bins.first - kSupportHalfWidth * bins.spacing;
  const int halves = 2 * (bins.count - 1 + 2 * kSupportHalfWidth);
  std::vector<double> cuts;
  for (int n = 0; n <= halves; ++n) cuts.push_back(begin + bins.spacing * n / 2);
  const double end = cuts.back();
  std::ranges::copy_if(edges, std::back_inserter(cuts),
                       [&](double edge) { return begin < edge && edge < end; });
  std::ranges::sort(cuts);
  // Edges of sharp bins that coincide with knots up to rounding errors are removed.
  constexpr double kCoincidenceTolerance = 1e-9;
  cuts.erase(
      std::unique(cuts.begin(), cuts.end(),
                  [&](double a, double b) { return b - a < kCoincidenceTolerance * bins.spacing; }),
      cuts.end());
  return cuts;
}

}  // namespace

double cardinal_cubic_spline(double t) {
  const double u = std::abs(t), outer = std::max(0.0, 2 - u), inner = std::max(0.0, 1 - u);
  return (outer * outer * outer - 4 * inner * inner * inner) / 6;
}

double smooth_bin_weight(const SmoothBins& bins, int bin) {
  const double t = (bins.from - bins.first) / bins.spacing - bin, u = std::abs(t);
  // The variable `beyond` is the integral of the cubic B-spline M over (u, 2).
  const double outer = std::max(0.0, 2 - u), inner = std::max(0.0, 1 - u);
  const double beyond = (std::pow(outer, 4) - 4 * std::pow(inner, 4)) / 24;
  return bins.spacing * (t >= 0 ? beyond : 1 - beyond);
}

Marginal smooth_bin_marginal(const SmoothBins& bins, std::vector<double> averages) {
  std::vector<double> edges{std::isfinite(bins.from) ? bins.from : bins.first - bins.spacing / 2};
  for (int b = 0; b < bins.count; ++b) edges.push_back(edges.back() + smooth_bin_weight(bins, b));
  return {.edges = std::move(edges), .density = std::move(averages), .lower = {}, .upper = {}};
}

Marginal average_over_smooth_bins(const Marginal& sharp, const SmoothBins& bins) {
  std::vector<double> masses;
  for (std::size_t k = 0; k < sharp.size(); ++k) {
    masses.push_back(sharp.density[k] * sharp.bin_width(k));
  }
  const std::vector<double> cuts = smooth_segment_ends(bins, sharp.edges);
  std::vector<double> nodes;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    for (int n = 0; n < kBooleIntervals; ++n) {
      nodes.push_back(cuts[k] + (cuts[k + 1] - cuts[k]) * n / kBooleIntervals);
    }
  }
  nodes.push_back(cuts.back());
  const std::vector<double> between = ConservativeRemap(sharp.edges, nodes)(masses);
  std::vector<double> averages;
  for (int b = 0; b < bins.count; ++b) {
    // Integration by parts gives int M p = -int F M' for the cumulative distribution F of p. Since
    // int M' = 0, a constant may be added to the cumulative distribution F, and F is set to 0 at
    // the left end of the support of M. The variables `begin` and `end` are the ends of the support
    // of the smooth bin b in units of the spacing.
    const double begin = b - kSupportHalfWidth, end = b + kSupportHalfWidth;
    const auto scaled_position = [&](double x) { return (x - bins.first) / bins.spacing; };
    double cumulative = 0, integral = 0;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const double middle = scaled_position((cuts[k] + cuts[k + 1]) / 2);
      if (middle < begin) continue;
      if (middle > end) break;
      const double width = (cuts[k + 1] - cuts[k]) / bins.spacing;
      for (int n = 0; n <= kBooleIntervals; ++n) {
        const std::size_t at = k * kBooleIntervals + static_cast<std::size_t>(n);
        if (n > 0) cumulative += between[at - 1];
        integral -=
            width * kBoole[n] * cumulative * cubic_spline_slope(scaled_position(nodes[at]) - b);
      }
    }
    averages.push_back(integral / smooth_bin_weight(bins, b));
  }
  return smooth_bin_marginal(bins, std::move(averages));
}

}  // namespace fpkcheck::transform
