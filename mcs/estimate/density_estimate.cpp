#include "mcs/estimate/density_estimate.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace fpkcheck::mcs {
namespace {

std::vector<std::vector<double>> bin_sums(const Simulation& simulation,
                                          transform::Variable variable) {
  std::vector<std::vector<double>> sums;  // shape (streams, n + 2), with the outer bins
  for (const Stream& stream : simulation.streams()) {
    const Histogram& histogram = stream.record.histogram;
    sums.push_back(variable == transform::Variable::y ? histogram.row_sums()
                                                      : histogram.column_sums());
  }
  return sums;
}

struct Interval {
  double lower, upper;
};

/// Confidence interval of the densities d with |d - mean| <= t s(d) and s^2(d) = error^2 d / mean.
/// The variance is proportional to the density, since the visits to a bin are nearly a Poisson
/// process. This interval is the score interval of Wilson (J. Am. Stat. Assoc. 22 (1927) 209) in
/// the limit of rare events. After few visits the true density is more often above the estimated
/// mean than below, and the interval mean +- t error then often misses the true density.
Interval score_interval(double mean, double error, double t) {
  const double shift = t * t * error * error / (2 * mean);
  const double half_width = std::sqrt(shift * (2 * mean + shift));
  return {std::max(mean + shift - half_width, 0.0), mean + shift + half_width};
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

// Multiplier bootstrap: a replicate multiplies the error contribution of each stream by a random
// normal factor. The L1 norms of the replicates have the distribution of the L1 sampling error.
L1SamplingError l1_sampling_error(const BinErrors& errors) {
  constexpr int kReplicates = 400;
  constexpr std::uint64_t kSeed = 20240501;  // arbitrary, but fixed: runs are reproducible
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

std::vector<std::vector<double>> cumulative_probabilities(const Simulation& simulation,
                                                          transform::Variable variable) {
  auto sums = bin_sums(simulation, variable);
  for (auto& stream : sums) {
    double below = 0;
    for (double& sum : stream) sum = below += sum / simulation.stream_samples();
    stream.pop_back();
  }
  return sums;
}

MarginalEstimate estimate_marginal(const Simulation& simulation, const StreamWeights& weights,
                                   transform::Variable variable, double effective_samples) {
  const auto& edges = simulation.plan().bin_finder(variable).edges();
  const auto sums = bin_sums(simulation, variable);
  MarginalEstimate result;
  auto& [marginal, errors] = result;
  marginal.edges = edges;
  std::vector<double> densities(sums.size());
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double width = marginal.width(b);
    const double unit = 1 / (simulation.stream_samples() * width);
    std::ranges::transform(sums, densities.begin(),
                           [&](const auto& stream_sums) { return stream_sums[b + 1] * unit; });
    const auto [mean, error] = weights.estimate(densities);
    const double density = std::max(mean, 0.0);  // see estimate_joint_density
    // If none of n independent draws is in the bin, the probability of the bin is below 3/n at 95 %
    // confidence ("rule of three").
    const Interval interval = density > 0
                                  ? score_interval(density, error, weights.interval_factor())
                                  : Interval{0, 3 / (effective_samples * width)};
    marginal.density.push_back(density);
    marginal.lower.push_back(interval.lower);
    marginal.upper.push_back(interval.upper);
    errors.push_back(weights.error_contributions(densities));
    for (double& part : errors.back()) part *= width;
  }
  return result;
}

JointEstimate estimate_joint_density(const Simulation& simulation, const StreamWeights& weights) {
  const SimulationPlan& plan = simulation.plan();
  JointEstimate joint{{plan.y_bins.edges(), plan.v_bins.edges(), {}}, {}};
  transform::GridDensity& density = joint.density;
  std::vector<double> values(simulation.streams().size());
  for (std::size_t i = 0; i < density.ny(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.nv(); ++j) {
      const double dv = density.v_edges[j + 1] - density.v_edges[j];
      const double unit = 1 / (simulation.stream_samples() * dy * dv);
      std::ranges::transform(simulation.streams(), values.begin(), [&](const Stream& stream) {
        return stream.record.histogram(i + 1, j + 1) * unit;
      });
      const auto [mean, error] = weights.estimate(values);
      // In short runs a stream of negative weight may be the only one to visit a cell of the far
      // tails.
      density.averages.push_back(std::max(mean, 0.0));
      joint.standard_errors.push_back(error);
    }
  }
  return joint;
}

}  // namespace fpkcheck::mcs
