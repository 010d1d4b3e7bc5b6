#include "transform/smooth_bins.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "transform/mass_transfer.hpp"

namespace fpkcheck::transform {
namespace {

constexpr int kReach = 2;        // spacings, of M to both sides
constexpr int kSubdivision = 8;  // of a spacing, a multiple of 4 for Boole's rule

double slope(double t) {
  const double u = std::abs(t), far = std::max(0.0, 2 - u), near = std::max(0.0, 1 - u);
  return std::copysign(1.0, t) * (12 * near * near - 3 * far * far) / 6;
}

/// Points that subdivide the spacings from the first bin's begin to the last one's end.
std::vector<double> nodes_of(const SmoothBins& bins) {
  const int spacings = bins.count - 1 + 2 * kReach;
  std::vector<double> nodes;
  for (int n = 0; n <= spacings * kSubdivision; ++n) {
    nodes.push_back(bins.first + bins.spacing * (static_cast<double>(n) / kSubdivision - kReach));
  }
  return nodes;
}

}  // namespace

double cubic_spline(double t) {
  const double u = std::abs(t), far = std::max(0.0, 2 - u), near = std::max(0.0, 1 - u);
  return (far * far * far - 4 * near * near * near) / 6;
}

double bin_weight(const SmoothBins& bins, int bin) {
  const double t = (bins.from - bins.first) / bins.spacing - bin, u = std::abs(t);
  // int_u^2 M for u >= 0
  const double far = std::max(0.0, 2 - u), near = std::max(0.0, 1 - u);
  const double beyond = (std::pow(far, 4) - 4 * std::pow(near, 4)) / 24;
  return bins.spacing * (t >= 0 ? beyond : 1 - beyond);
}

Marginal marginal_of(const SmoothBins& bins, std::vector<double> averages) {
  std::vector<double> edges{std::isfinite(bins.from) ? bins.from : bins.first - bins.spacing / 2};
  for (int b = 0; b < bins.count; ++b) edges.push_back(edges.back() + bin_weight(bins, b));
  return {.edges = std::move(edges), .density = std::move(averages), .lower = {}, .upper = {}};
}

Marginal smooth_averages(const Marginal& sharp, const SmoothBins& bins) {
  std::vector<double> masses;
  for (std::size_t k = 0; k < sharp.size(); ++k) {
    masses.push_back(sharp.density[k] * sharp.width(k));
  }
  const std::vector<double> nodes = nodes_of(bins);
  const std::vector<double> between = MassTransfer(sharp.edges, nodes)(masses);
  std::vector<double> averages;
  for (int b = 0; b < bins.count; ++b) {
    // int M p = -int F M', where F = 0 at the begin of M serves as well as the whole cumulative.
    const std::size_t begin = static_cast<std::size_t>(b) * kSubdivision;
    double cumulative = 0, integral = 0;
    for (int n = 1; n < 2 * kReach * kSubdivision; ++n) {
      cumulative += between[begin + static_cast<std::size_t>(n) - 1];
      const double weight = n % 2 == 1 ? 32 : n % 4 == 2 ? 12 : 14;  // M' is 0 at both ends
      integral -=
          2.0 / 45 * weight * cumulative * slope(static_cast<double>(n) / kSubdivision - kReach);
    }
    averages.push_back(integral / kSubdivision / bin_weight(bins, b));
  }
  return marginal_of(bins, std::move(averages));
}

}  // namespace fpkcheck::transform
