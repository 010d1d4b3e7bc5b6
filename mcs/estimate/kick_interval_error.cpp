#include "mcs/estimate/kick_interval_error.hpp"

#include <algorithm>
#include <cmath>

#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::mcs {

bool kick_interval_affects_stationary_density(const SimulationPlan& plan) {
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

double kick_interval_error(double difference, double standard_error, int order) {
  return std::max(std::abs(difference), standard_error) / (std::exp2(order) - 1);
}

double kick_interval_l1_error(double l1_distance, double expected_by_chance,
                              double largest_by_chance, int order) {
  // The sampling errors of the bins increase the L1 distance between two simulations. An L1
  // distance that sampling errors may explain counts as half of the mean distance by sampling
  // errors.
  constexpr double kUnresolvedFraction = 0.5;
  const double resolved =
      l1_distance <= largest_by_chance
          ? kUnresolvedFraction * expected_by_chance
          : std::sqrt(l1_distance * l1_distance - expected_by_chance * expected_by_chance);
  return resolved / (std::exp2(order) - 1);
}

std::optional<double> longest_kick_interval(const SimulationPlan& plan) {
  if (plan.kicks.is_acting()) return plan.kicks.longest_interval;
  const bool is_even = plan.excitation.arrivals == ImpulseProcess::Arrivals::even;
  return is_even ? std::optional(plan.excitation.interval) : std::nullopt;
}

void scale_kick_intervals(const problem::Problem& problem, double factor, SimulationPlan& plan) {
  const double before = *longest_kick_interval(plan);
  if (plan.kicks.is_acting()) {
    plan.kicks.longest_interval *= factor;
    plan.kicks.shortest_interval *= factor;
  } else {
    plan.excitation = white_noise_impulse_process(problem.impulses, factor * before);
  }
  plan.expected_event_rate += 1 / (factor * before) - 1 / before;
}

std::optional<SimulationPlan> plan_with_doubled_kick_interval(const problem::Problem& problem,
                                                              const SimulationPlan& plan) {
  if (!longest_kick_interval(plan)) return std::nullopt;
  SimulationPlan doubled = plan;
  doubled.deposit = std::nullopt;
  doubled.seed = ~plan.seed;  // other random numbers than those of the first simulation
  scale_kick_intervals(problem, 2, doubled);
  doubled.kicks.fraction_near_wall *= 2;
  return doubled;
}

transform::ErrorEstimate estimate_kick_interval_error(const transform::Solution& solution,
                                                      const Simulation& doubled) {
  const int order = order_in_kick_interval(doubled.plan_of_simulation());
  const TrajectoryStreamWeights weights(excess_impulse_power_per_stream(doubled));
  const MomentEstimates moments = estimate_moments(doubled, weights);
  transform::ErrorEstimate error;
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    const double by_chance =
        std::hypot(solution.standard_errors->moments.*moment, moments.standard_errors.*moment);
    const double difference = moments.means.*moment - solution.moments.*moment;
    error.moments.*moment = kick_interval_error(difference, by_chance, order);
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
    return kick_interval_l1_error(l1, by_chance, largest_by_chance, order);
  };
  error.y_l1 = l1_error(transform::StateVariable::y);
  error.ydot_l1 = l1_error(transform::StateVariable::ydot);
  return error;
}

}  // namespace fpkcheck::mcs
