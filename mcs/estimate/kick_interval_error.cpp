#include "mcs/estimate/kick_interval_error.hpp"

#include <algorithm>
#include <cmath>

#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::mcs {
namespace {

bool interval_causes_error(const SimulationPlan& plan) {
  if (plan.excitation.arrivals == ImpulseProcess::Arrivals::even) return true;
  const SimulatedOscillator& oscillator = plan.oscillator;
  const bool is_exact = plan.kicks.damping > 0 && !oscillator.left.has_impact_losses() &&
                        !oscillator.right.has_impact_losses() &&
                        std::isinf(plan.excitation.interval);
  return plan.kicks.is_acting() && !is_exact;
}

int order_in_kick_interval(const SimulationPlan& plan) {
  const SimulatedOscillator& oscillator = plan.oscillator;
  const bool is_first_order = oscillator.left.has_impact_losses() ||
                              oscillator.right.has_impact_losses() || oscillator.has_jumps;
  return is_first_order ? 1 : 2;
}

}  // namespace

std::optional<SimulationPlan> plan_with_doubled_kick_interval(const problem::Problem& problem,
                                                              const SimulationPlan& plan) {
  if (!interval_causes_error(plan)) return std::nullopt;
  SimulationPlan doubled = plan;
  doubled.deposit = std::nullopt;
  doubled.seed = ~plan.seed;  // other random numbers than those of the first simulation
  if (plan.kicks.is_acting()) {
    doubled.kicks.longest_interval *= 2;
    doubled.kicks.shortest_interval *= 2;
    doubled.kicks.fraction_near_wall *= 2;
  } else {
    doubled.excitation =
        white_noise_impulse_process(problem.impulses, 2 * plan.excitation.interval);
  }
  return doubled;
}

transform::ErrorEstimate estimate_kick_interval_error(const transform::Solution& solution,
                                                      const Simulation& doubled) {
  // The error at the kick interval h is a fraction 1/(2^p - 1) of the difference between the
  // results at 2h and h, with the order p.
  const double fraction = 1 / (std::exp2(order_in_kick_interval(doubled.plan_of_simulation())) - 1);
  const TrajectoryStreamWeights weights(excess_impulse_power_per_stream(doubled));
  const MomentEstimates moments = estimate_moments(doubled, weights);
  transform::ErrorEstimate error;
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    const double by_chance =
        std::hypot(solution.standard_errors->moments.*moment, moments.standard_errors.*moment);
    const double difference = std::abs(moments.means.*moment - solution.moments.*moment);
    error.moments.*moment = fraction * std::max(by_chance, difference);
  }
  const auto l1_error = [&](transform::StateVariable variable) {
    // The number of effective samples affects only confidence limits, which the estimate of the
    // kick error does not use.
    constexpr double kAnyNumber = 1;
    const auto [marginal, bin_errors] = estimate_marginal(doubled, weights, variable, kAnyNumber);
    const L1SamplingError sampling = l1_sampling_error(bin_errors);
    const double l1 =
        transform::l1_distance(transform::marginal(solution, variable, marginal.edges), marginal);
    const double by_chance =
        std::hypot(*transform::expected_l1_error(*solution.sampling, variable), sampling.expected);
    const double largest_by_chance = std::hypot(
        *transform::l1_error_quantile_99(*solution.sampling, variable), sampling.quantile_99);
    // The sampling errors of the bins increase the L1 distance between two simulations. An L1
    // distance that sampling errors may explain counts as half of the mean distance by sampling
    // errors.
    constexpr double kUnresolvedFraction = 0.5;
    if (l1 <= largest_by_chance) return fraction * kUnresolvedFraction * by_chance;
    return fraction * std::sqrt(l1 * l1 - by_chance * by_chance);
  };
  error.y_l1 = l1_error(transform::StateVariable::y);
  error.ydot_l1 = l1_error(transform::StateVariable::ydot);
  return error;
}

}  // namespace fpkcheck::mcs
