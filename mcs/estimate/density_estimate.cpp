#include "mcs/estimate/density_estimate.hpp"

#include <algorithm>
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace fpkcheck::mcs {
namespace {

std::vector<std::vector<double>> bin_sums_per_stream(const Simulation& simulation,
                                                     transform::StateVariable variable) {
  std::vector<std::vector<double>> sums;  // shape (streams, n + 2) including the two outer bins
  for (const TrajectoryStream& stream : simulation.trajectory_streams()) {
    const JointHistogram& histogram = stream.record.histogram;
    sums.push_back(variable == transform::StateVariable::y ? histogram.row_sums()
                                                           : histogram.column_sums());
  }
  return sums;
}

struct IntervalOfConstantDensity {
  double lower, upper;
};

/// Returns the score interval of Wilson (Journal of the American Statistical Association 22 (1927)
/// 209) for rare events: the densities d with |d - mean| <= t s(d) and s^2(d) = error^2 d / mean.
/// The variance s^2(d) is proportional to the density d, since the visits to a bin are nearly a
/// Poisson process. After few visits to a bin the interval mean +- t error often misses the true
/// density, which is above the interval more often than below the interval.
IntervalOfConstantDensity score_interval(double mean, double error, double t) {
  const double shift = t * t * error * error / (2 * mean);
  const double half_width = std::sqrt(shift * (2 * mean + shift));
  return {std::max(mean + shift - half_width, 0.0), mean + shift + half_width};
}

/// Returns the probabilities that the variable is below each bin edge, estimated from each
/// trajectory stream, shape (streams, edges).
std::vector<std::vector<double>> cumulative_probabilities(const Simulation& simulation,
                                                          transform::StateVariable variable) {
  auto sums = bin_sums_per_stream(simulation, variable);
  for (auto& stream : sums) {
    double below = 0;
    for (double& sum : stream) sum = below += sum / simulation.expected_samples_per_stream();
    stream.pop_back();
  }
  return sums;
}

constexpr std::array kProbabilities{1e-4, 1e-3, 0.01, 0.05,  0.25,  0.5,
                                    0.75, 0.95, 0.99, 0.999, 0.9999};

/// Distribution function, given by nondecreasing values at the edges of bins.
class DistributionFunction {
 public:
  DistributionFunction(const std::vector<double>& edges, std::vector<double> below)
      : edges_(edges), below_(std::move(below)) {
    for (std::size_t k = 1; k < below_.size(); ++k) below_[k] = std::max(below_[k], below_[k - 1]);
  }

  bool is_in_range(double p) const { return p > below_.front() && p < below_.back(); }

  /// Returns the quantile of the probability p, by inverting the cubic through the values of the
  /// distribution function at four bin edges.
  double quantile_of_probability(double p) const {
    const auto above = std::ranges::upper_bound(below_, p) - below_.begin();
    const auto count = static_cast<std::ptrdiff_t>(edges_.size());
    const auto k = std::clamp<std::ptrdiff_t>(above, 1, count - 1);
    double low = edges_[k - 1], high = edges_[k];
    const auto first = std::clamp<std::ptrdiff_t>(k - 2, 0, std::max<std::ptrdiff_t>(count - 4, 0));
    for (int bisection = 0; bisection < 60; ++bisection) {
      const double middle = (low + high) / 2;
      (interpolating_cubic(first, middle) < p ? low : high) = middle;
    }
    return (low + high) / 2;
  }

 private:
  double interpolating_cubic(std::ptrdiff_t first, double x) const {
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

/// Transforms quantiles to physical coordinates; mirroring exchanges lower and upper tail.
std::vector<QuantileWithConfidenceInterval> to_physical_coordinates(
    const problem::WallFrame& frame, transform::StateVariable variable,
    std::vector<QuantileWithConfidenceInterval> quantiles) {
  const auto to_physical = [&](double x) {
    return variable == transform::StateVariable::y ? frame.physical_y(x)
                                                   : frame.physical_velocity(x);
  };
  for (QuantileWithConfidenceInterval& q : quantiles) {
    q = {q.probability, to_physical(q.value), to_physical(q.lower), to_physical(q.upper)};
    if (!frame.mirrored) continue;
    q.probability = 1 - q.probability;
    std::swap(q.lower, q.upper);
  }
  if (frame.mirrored) std::ranges::reverse(quantiles);
  return quantiles;
}

}  // namespace

double expected_l1_error(const BinErrors& errors) {
  double sum = 0;
  for (const auto& bin : errors) {
    sum += std::sqrt(2 / std::numbers::pi *
                     std::inner_product(bin.begin(), bin.end(), bin.begin(), 0.0));
  }
  return sum;
}

// The quantile is computed by multiplier bootstrap: each replicate multiplies the error
// contribution of each trajectory stream by a random normal factor. The L1 norms of the bootstrap
// replicates have approximately the distribution of the L1 sampling error.
L1SamplingError l1_sampling_error(const BinErrors& errors) {
  constexpr int kReplicates = 400;
  // arbitrary constant seed of the bootstrap, so that runs are reproducible
  constexpr std::uint64_t kSeed = 20240501;
  L1SamplingError result{.expected = expected_l1_error(errors), .quantile_99 = 0};
  if (errors.empty()) return result;
  boost::random::mt19937_64 engine(kSeed);
  boost::random::normal_distribution<double> normal;
  std::vector<double> factors(errors.front().size()), distances;
  for (int k = 0; k < kReplicates; ++k) {
    for (double& factor : factors) factor = normal(engine);
    double distance = 0;
    for (const auto& bin : errors) {
      distance += std::abs(std::inner_product(bin.begin(), bin.end(), factors.begin(), 0.0));
    }
    distances.push_back(distance);
  }
  const auto nth = distances.begin() + kReplicates * 99 / 100;
  std::ranges::nth_element(distances, nth);
  result.quantile_99 = *nth;
  return result;
}

MarginalDensityEstimate estimate_marginal(const Simulation& simulation,
                                          const TrajectoryStreamWeights& weights,
                                          transform::StateVariable variable,
                                          double effective_samples) {
  const auto& edges = simulation.plan_of_simulation().bin_finder_of_variable(variable).edges();
  const auto sums = bin_sums_per_stream(simulation, variable);
  MarginalDensityEstimate result;
  auto& [marginal, errors] = result;
  marginal.edges = edges;
  std::vector<double> densities(sums.size());
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double width = marginal.bin_width(b);
    const double unit = 1 / (simulation.expected_samples_per_stream() * width);
    std::ranges::transform(sums, densities.begin(),
                           [&](const auto& stream_sums) { return stream_sums[b + 1] * unit; });
    const auto [mean, error] = weights.estimate_mean(densities);
    // The mean density in a bin may be negative, as explained in estimate_joint_density().
    const double density = std::max(mean, 0.0);
    // If no sample of n independent samples is in a bin, the probability of the bin is below 3/n at
    // 95 % confidence ("rule of three").
    const IntervalOfConstantDensity interval =
        density > 0 ? score_interval(density, error, weights.confidence_interval_factor())
                    : IntervalOfConstantDensity{0, 3 / (effective_samples * width)};
    marginal.density.push_back(density);
    marginal.lower.push_back(interval.lower);
    marginal.upper.push_back(interval.upper);
    errors.push_back(weights.stream_error_contributions(densities));
    for (double& part : errors.back()) part *= width;
  }
  return result;
}

JointDensityEstimate estimate_joint_density(const Simulation& simulation,
                                            const TrajectoryStreamWeights& weights) {
  const SimulationPlan& plan = simulation.plan_of_simulation();
  JointDensityEstimate joint{{plan.y_bins.edges(), plan.v_bins.edges(), {}}, {}};
  transform::GridDensity& density = joint.density;
  std::vector<double> values(simulation.trajectory_streams().size());
  for (std::size_t i = 0; i < density.y_cell_count(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.v_cell_count(); ++j) {
      const double dv = density.v_edges[j + 1] - density.v_edges[j];
      const double unit = 1 / (simulation.expected_samples_per_stream() * dy * dv);
      std::ranges::transform(simulation.trajectory_streams(), values.begin(),
                             [&](const TrajectoryStream& stream) {
                               return stream.record.histogram(i + 1, j + 1) * unit;
                             });
      const auto [mean, error] = weights.estimate_mean(values);
      // In short simulations the mean density of a cell in the far tails is negative if only a
      // trajectory stream of negative weight visits the cell.
      density.averages.push_back(std::max(mean, 0.0));
      joint.standard_errors.push_back(error);
    }
  }
  return joint;
}

std::vector<QuantileWithConfidenceInterval> estimate_quantiles(
    const Simulation& simulation, const TrajectoryStreamWeights& weights,
    transform::StateVariable variable) {
  const auto& edges = simulation.plan_of_simulation().bin_finder_of_variable(variable).edges();
  const auto streams = cumulative_probabilities(simulation, variable);
  std::vector<double> mean, error, values(streams.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    std::ranges::transform(streams, values.begin(), [&](const auto& below) { return below[k]; });
    const MeanEstimate estimate = weights.estimate_mean(values);
    mean.push_back(estimate.mean);
    error.push_back(estimate.standard_error);
  }
  const DistributionFunction distribution(edges, mean);
  std::vector<QuantileWithConfidenceInterval> quantiles;
  for (const double p : kProbabilities) {
    if (!distribution.is_in_range(p)) continue;
    const double value = distribution.quantile_of_probability(p);
    const auto k =
        std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(edges, value) - edges.begin(), 1,
                                   static_cast<std::ptrdiff_t>(edges.size()) - 1);
    const double share = (value - edges[k - 1]) / (edges[k] - edges[k - 1]);
    const double half =
        weights.confidence_interval_factor() * ((1 - share) * error[k - 1] + share * error[k]);
    if (!distribution.is_in_range(p - half) || !distribution.is_in_range(p + half)) continue;
    quantiles.push_back({p, value, distribution.quantile_of_probability(p - half),
                         distribution.quantile_of_probability(p + half)});
  }
  const problem::WallFrame& frame = simulation.plan_of_simulation().frame;
  return frame.is_identity() ? quantiles
                             : to_physical_coordinates(frame, variable, std::move(quantiles));
}

}  // namespace fpkcheck::mcs
