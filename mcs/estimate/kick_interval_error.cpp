#include "mcs/estimate/kick_interval_error.hpp"

#include <algorithm>
#include <cmath>

#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {
namespace {

bool interval_causes_error(const SimulationPlan& plan) {
  if (plan.excitation.arrivals == Excitation::Arrivals::even) return true;
  const Oscillator& oscillator = plan.oscillator;
  const bool is_exact = plan.kicks.damping > 0 && !oscillator.left.is_lossy() &&
                        !oscillator.right.is_lossy() && std::isinf(plan.excitation.interval);
  return plan.kicks.is_present() && !is_exact;
}

int order_in_kick_interval(const SimulationPlan& plan) {
  const Oscillator& oscillator = plan.oscillator;
  const bool is_first_order =
      oscillator.left.is_lossy() || oscillator.right.is_lossy() || oscillator.has_jumps;
  return is_first_order ? 1 : 2;
}

}  // namespace

std::optional<SimulationPlan> plan_with_doubled_kick_interval(const problem::Problem& problem,
                                                              const SimulationPlan& plan) {
  if (!interval_causes_error(plan)) return std::nullopt;
  SimulationPlan doubled = plan;
  doubled.deposit = std::nullopt;
  doubled.seed = ~plan.seed;  // other random numbers than those of the first simulation
  if (plan.kicks.is_present()) {
    doubled.kicks.longest_interval *= 2;
    doubled.kicks.shortest_interval *= 2;
    doubled.kicks.part_near_wall *= 2;
  } else {
    doubled.excitation = white_noise_excitation(problem.impulses, 2 * plan.excitation.interval);
  }
  return doubled;
}

transform::ErrorEstimate estimate_kick_interval_error(const Simulation& simulation,
                                                      const Simulation& doubled) {
  // The error of step h is a fraction 1/(2^p - 1) of the difference between the steps 2h and h.
  const double fraction = 1 / (std::exp2(order_in_kick_interval(simulation.plan())) - 1);
  const StreamWeights weights(excess_impulse_power_per_stream(simulation));
  const StreamWeights doubled_weights(excess_impulse_power_per_stream(doubled));
  transform::ErrorEstimate error;
  const auto set_moment_error = [&](double transform::Moments::*moment, int p, int q) {
    const MeanEstimate a = weights.estimate_mean(moment_per_stream(simulation, p, q));
    const MeanEstimate b = doubled_weights.estimate_mean(moment_per_stream(doubled, p, q));
    const double by_chance = std::hypot(a.standard_error, b.standard_error);
    error.moments.*moment = fraction * std::max(by_chance, std::abs(b.mean - a.mean));
  };
  using transform::Moments;
  set_moment_error(&Moments::y1, 1, 0);
  set_moment_error(&Moments::y2, 2, 0);
  set_moment_error(&Moments::y4, 4, 0);
  set_moment_error(&Moments::v1, 0, 1);
  set_moment_error(&Moments::v2, 0, 2);
  set_moment_error(&Moments::v4, 0, 4);
  const auto l1_error = [&](transform::StateVariable variable) {
    // The number of effective samples affects only the confidence limits, which are not used here.
    constexpr double kAnyNumber = 1;
    const MarginalEstimate a = estimate_marginal(simulation, weights, variable, kAnyNumber);
    const MarginalEstimate b = estimate_marginal(doubled, doubled_weights, variable, kAnyNumber);
    const double l1 = transform::l1_distance(a.marginal, b.marginal);
    const L1SamplingError of_a = l1_sampling_error(a.errors), of_b = l1_sampling_error(b.errors);
    // The sampling errors of the bins increase the distance. A distance that they may explain counts
    // as half of the expected distance by sampling errors.
    constexpr double kHidden = 0.5;
    const double by_chance = std::hypot(of_a.expected, of_b.expected);
    if (l1 <= std::hypot(of_a.quantile_99, of_b.quantile_99)) return fraction * kHidden * by_chance;
    return fraction * std::sqrt(l1 * l1 - by_chance * by_chance);
  };
  error.y_l1 = l1_error(transform::StateVariable::y);
  error.ydot_l1 = l1_error(transform::StateVariable::ydot);
  return error;
}

}  // namespace fpkcheck::mcs
