#include "mcs/estimate/quantiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "mcs/estimate/density_estimate.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::array kProbabilities{1e-4, 1e-3, 0.01, 0.05,  0.25,  0.5,
                                    0.75, 0.95, 0.99, 0.999, 0.9999};

/// A distribution function, given by nondecreasing values at the edges of bins.
class DistributionFunction {
 public:
  DistributionFunction(const std::vector<double>& edges, std::vector<double> below)
      : edges_(edges), below_(std::move(below)) {
    for (std::size_t k = 1; k < below_.size(); ++k) below_[k] = std::max(below_[k], below_[k - 1]);
  }

  bool is_in_range(double p) const { return p > below_.front() && p < below_.back(); }

  /// Quantile of the probability p: inverts the cubic through the values at four edges, between the
  /// two middle edges.
  double inverse(double p) const {
    const auto above = std::ranges::upper_bound(below_, p) - below_.begin();
    const auto count = static_cast<std::ptrdiff_t>(edges_.size());
    const auto k = std::clamp<std::ptrdiff_t>(above, 1, count - 1);
    double low = edges_[k - 1], high = edges_[k];
    const auto first = std::clamp<std::ptrdiff_t>(k - 2, 0, std::max<std::ptrdiff_t>(count - 4, 0));
    for (int bisection = 0; bisection < 60; ++bisection) {
      const double middle = (low + high) / 2;
      (cubic(first, middle) < p ? low : high) = middle;
    }
    return (low + high) / 2;
  }

 private:
  double cubic(std::ptrdiff_t first, double x) const {
    const auto end =
        std::min<std::ptrdiff_t>(first + 4, static_cast<std::ptrdiff_t>(edges_.size()));
    double sum = 0;
    for (auto a = first; a < end; ++a) {
      double weight = 1;
      for (auto b = first; b < end; ++b) {
        if (b != a) weight *= (x - edges_[b]) / (edges_[a] - edges_[b]);
      }
      sum += weight * below_[a];
    }
    return sum;
  }

  const std::vector<double>& edges_;
  std::vector<double> below_;
};

/// Maps quantiles to physical coordinates. A mirrored axis exchanges lower and upper tails.
std::vector<Quantile> to_physical_coordinates(const problem::Frame& frame,
                                              transform::Variable variable,
                                              std::vector<Quantile> quantiles) {
  const auto to_physical = [&](double x) {
    return variable == transform::Variable::y ? frame.physical_y(x) : frame.physical_velocity(x);
  };
  for (Quantile& q : quantiles) {
    q = {q.probability, to_physical(q.value), to_physical(q.lower), to_physical(q.upper)};
    if (!frame.mirrored) continue;
    q.probability = 1 - q.probability;
    std::swap(q.lower, q.upper);
  }
  if (frame.mirrored) std::ranges::reverse(quantiles);
  return quantiles;
}

}  // namespace

std::vector<Quantile> estimate_quantiles(const Simulation& simulation, const StreamWeights& weights,
                                         transform::Variable variable) {
  const auto& edges = simulation.plan().bin_finder(variable).edges();
  const auto streams = cumulative_probabilities(simulation, variable);
  std::vector<double> mean, error, values(streams.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    std::ranges::transform(streams, values.begin(), [&](const auto& below) { return below[k]; });
    const Estimate estimate = weights.estimate(values);
    mean.push_back(estimate.mean);
    error.push_back(estimate.standard_error);
  }
  const DistributionFunction distribution(edges, mean);
  std::vector<Quantile> quantiles;
  for (const double p : kProbabilities) {
    if (!distribution.is_in_range(p)) continue;
    const double value = distribution.inverse(p);
    const auto k =
        std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(edges, value) - edges.begin(), 1,
                                   static_cast<std::ptrdiff_t>(edges.size()) - 1);
    const double share = (value - edges[k - 1]) / (edges[k] - edges[k - 1]);
    const double half = weights.interval_factor() * ((1 - share) * error[k - 1] + share * error[k]);
    if (!distribution.is_in_range(p - half) || !distribution.is_in_range(p + half)) continue;
    quantiles.push_back({p, value, distribution.inverse(p - half), distribution.inverse(p + half)});
  }
  const problem::Frame& frame = simulation.plan().frame;
  return frame.is_identity() ? quantiles
                             : to_physical_coordinates(frame, variable, std::move(quantiles));
}

}  // namespace fpkcheck::mcs
