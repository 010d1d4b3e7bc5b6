#include "backward/passage/passage_bounds.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "base/process/stopwatch.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

using transform::FirstPassageResult;
using transform::Status;

std::string mean_bounds_unsupported_reason(const problem::Problem& problem, double barrier,
                                           bool has_start) {
  if (problem.noise.is_acting() || !problem.impulses.is_acting() || problem.impulse_factor) {
    return "the bounds are for impulses alone, without a factor; use fd or mcs";
  }
  const problem::ImpulseLaw& law = problem.impulses.amplitude_law();
  if (law.name() != "gaussian" || law.mean() != 0) {
    return "the bounds are for Gaussian impulses with mean 0; use characteristics, fd or mcs";
  }
  const problem::System& system = problem.system;
  const auto& wall = system.left_wall();
  if (!wall || wall->position != 0 || !wall->has_constant_restitution() || system.right_wall()) {
    return "the bounds are for one wall at y = 0 with a constant restitution coefficient; use "
           "characteristics, fd or mcs";
  }
  if (!system.has_constant_damping() || system.damping() < 0) {
    return "the bounds are for linear damping c >= 0; use characteristics, fd or mcs";
  }
  const auto& g = system.restoring_force().coefficients();
  if (g[0] != 0 || !(g[1] > 0) || g[2] != 0 || g[3] < 0 || g[4] != 0 || g[5] != 0) {
    return "the bounds are for the force k y + mu y^3 with k > 0 and mu >= 0; use "
           "characteristics, fd or mcs";
  }
  if (has_start) return "the bounds are for the start at rest; use characteristics, fd or mcs";
  return problem::barrier_unsupported_reason(problem, barrier);
}

}  // namespace

ImpactOscillator impact_oscillator(const problem::Problem& problem, double barrier) {
  const problem::System& system = problem.system;
  return {.damping = system.damping(),
          .stiffness = system.restoring_force().coefficient(1),
          .cubic = system.restoring_force().coefficient(3),
          .restitution = system.left_wall()->restitution,
          .arrival_rate = problem.impulses.arrival_rate(),
          .deviation = problem.impulses.amplitude_law().amplitude_standard_deviation(),
          .barrier = barrier};
}

FirstPassageResult bound_passage(const problem::Problem& problem,
                                 const PassageBoundsOptions& options, double barrier,
                                 std::optional<transform::PassageStartState> start) {
  const base::Stopwatch stopwatch;
  const base::Deadline deadline(options.max_seconds);
  FirstPassageResult passage{.id = "bounds"};
  passage.has_guaranteed_errors = true;
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const double wall_barrier = transformed.frame.wall_coordinate(barrier);
  passage.reason = mean_bounds_unsupported_reason(transformed, wall_barrier, start.has_value());
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  const ImpactOscillator oscillator = impact_oscillator(transformed, wall_barrier);
  const auto certificates = compute_mean_time_certificates(transformed, oscillator, deadline);
  std::array<double, 2> bounds{};  // upper, lower
  // Refinements of the rectangles on which the inequality is verified, tried in this order
  constexpr std::array kRefinements = {1.4, 2.2, 3.3};
  bool is_proved = certificates.has_value();
  for (std::size_t k = 0; k < 2 && is_proved; ++k) {
    VerifiedPassageTimeBound verified;
    for (const double refinement : kRefinements) {
      verified = verify_certificate((*certificates)[k], oscillator, refinement, deadline);
      if (verified.is_proved || deadline.has_deadline_passed()) break;
    }
    is_proved = verified.is_proved;
    bounds[k] = verified.bound;
  }
  passage.seconds = stopwatch.seconds();
  if (!is_proved) {
    passage.reason = deadline.has_deadline_passed()
                         ? fmt::format("the time limit of {:g} s is reached; raise --max-seconds",
                                       options.max_seconds)
                     : certificates
                         ? "the inequality of the bounds is not proved; use characteristics"
                         : "the bounds need more than 5000 nodes: the barrier is too high or "
                           "impulses are too frequent; use characteristics";
    return passage;
  }
  const auto [upper, lower] = bounds;
  passage.mean_from_point = {(lower + upper) / 2, (upper - lower) / 2};
  constexpr double kRounding = 5e-6;  // largest relative rounding error of six digits
  passage.details = fmt::format("{:.6g} <= mean time <= {:.6g}", lower * (1 - kRounding),
                                upper * (1 + kRounding));
  const double relative = passage.mean_from_point->error / passage.mean_from_point->value;
  passage.status = relative <= options.accuracy ? Status::ok : Status::inaccurate;
  if (passage.status == Status::inaccurate) {
    passage.reason = fmt::format("relative half-width {:.2g}, above the accuracy {:g}", relative,
                                 options.accuracy);
  }
  return passage;
}

}  // namespace fpkcheck::backward
