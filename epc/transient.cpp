#include "epc/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/process/stopwatch.hpp"
#include "epc/contact/coordinates.hpp"
#include "epc/formulations.hpp"
#include "epc/solve.hpp"
#include "problem/motion_scales.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;
using transform::TransientRequest;

// Smallest standard deviations of the initial density, relative to the stationary standard
// deviations and to the root mean square of an impulse.
constexpr double kLeastStationaryFraction = 0.3, kLeastImpulseFraction = 0.5;
// Shortest time limit, in seconds, of the solution over time by the closure of order n-2.
constexpr double kShortestSeconds = 0.1;

std::string narrow_start_reason(const problem::Problem& problem,
                                const problem::MotionScales& scales,
                                const problem::InitialGaussian& start,
                                const ClosureOptions& options) {
  const bool has_impulses =
      closure_density_equation(options) != DensityEquation::white && problem.impulses.is_acting();
  const double impulse =
      has_impulses
          ? std::sqrt(problem.impulses.rate_times_moment(2) / problem.impulses.arrival_rate())
          : 0;
  const double least_y = kLeastStationaryFraction * scales.displacement_deviation;
  const double least_v = std::max(kLeastStationaryFraction * scales.velocity_deviation,
                                  kLeastImpulseFraction * impulse);
  if (start.displacement_deviation >= least_y && start.velocity_deviation >= least_v) return "";
  return fmt::format(
      "the initial density is too narrow for a closure: deviations {:.3g} and {:.3g}; use at least "
      "{:.3g} and {:.3g}, or fd and mcs",
      start.displacement_deviation, start.velocity_deviation, least_y, least_v);
}

// Returns the reason why the formulation `gaussian` does not support a density over time.
std::string gaussian_transient_unsupported_reason(const problem::Problem& problem,
                                                  const problem::InitialGaussian& start,
                                                  const ClosureOptions& options) {
  if (closure_density_equation(options) == DensityEquation::kf) {
    return "the closure gaussian over time supports the equations km4 and white";
  }
  if (problem.time.is_acting()) {
    return "the closure gaussian supports no excitation that changes in time; use moment or polar";
  }
  if (problem.system.left_wall() && (start.mean_displacement != 0 || start.mean_velocity != 0)) {
    return "the closure gaussian over time starts from a density centred at rest at the wall; set "
           "--start-mean-y to the position of the wall and --start-mean-v to 0";
  }
  return "";
}

std::string transient_unsupported_reason(const problem::Problem& problem,
                                         const problem::InitialGaussian& start,
                                         const ClosureOptions& options) {
  if (options.formulation == Formulation::gaussian) {
    std::string reason = gaussian_transient_unsupported_reason(problem, start, options);
    if (!reason.empty()) return reason;
  }
  if (std::string reason = unsupported_reason(problem, options); !reason.empty()) return reason;
  if (options.formulation == Formulation::polar &&
      contact::spring_presses_on_single_wall(problem)) {
    return "the closure over time supports no mass at rest in contact; use mcs";
  }
  return "";
}

ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request) {
  switch (options.formulation) {
    case Formulation::gaussian:
      return gaussian::solve_evolution(problem, options, request);
    case Formulation::moment:
      return moment::solve_evolution(problem, options, request);
    case Formulation::polar:
      return polar::solve_evolution(problem, options, request);
  }
  return {};
}

std::vector<transform::TransientDensitySnapshot> make_transient_snapshots(
    const problem::Problem& problem, const ClosureEvolution& evolution,
    const TransientRequest& request) {
  std::vector<transform::TransientDensitySnapshot> snapshots;
  for (const ClosureSnapshot& closure : evolution.snapshots) {
    const transform::Density density =
        transform::to_physical_coordinates(problem.frame, closure.density);
    snapshots.push_back(
        {.time = closure.time,
         .moments = closure.moments,
         .y = transform::marginal(density, transform::StateVariable::y, request.y_edges),
         .ydot = transform::marginal(density, transform::StateVariable::ydot, request.v_edges)});
  }
  return snapshots;
}

}  // namespace

transform::TransientDensities solve_transient(const problem::Problem& problem,
                                              const ClosureOptions& options,
                                              const TransientRequest& request) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::TransientDensities transient{.id = solution_id(options)};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system),
                                   problem::with_largest_excitation(problem, request.time_span()));
  const problem::MotionScales scales = problem::motion_scales(transformed);
  const problem::InitialGaussian start =
      problem::initial_density(transformed, scales, request.start);
  transient.reason = transient_unsupported_reason(transformed, start, options);
  if (transient.reason.empty()) {
    transient.reason = narrow_start_reason(transformed, scales, start, options);
  }
  if (!transient.reason.empty()) {
    transient.status = Status::not_offered;
    return transient;
  }
  EvolutionRequest evolution_request{.start = start, .times = {}, .periodic = request.periodic};
  for (int k = 0; k <= request.snapshots; ++k)
    evolution_request.times.push_back(request.time_of_snapshot(k));
  const ClosureEvolution evolution = solve_evolution(transformed, options, evolution_request);
  transient.snapshots = make_transient_snapshots(transformed, evolution, request);
  if (options.order > 2) {
    ClosureOptions lower = options;
    lower.order -= 2;
    lower.max_seconds = std::max(kShortestSeconds, options.max_seconds - stopwatch.seconds());
    const ClosureEvolution previous = solve_evolution(transformed, lower, evolution_request);
    transform::estimate_errors_by_differences(
        make_transient_snapshots(transformed, previous, request),
        std::numbers::pi / scales.frequency, transient.snapshots);
  }
  transient.status = evolution.status;
  transient.reason = evolution.reason;
  transient.details =
      fmt::format("{} quadrature points, {} steps", evolution.quadrature, evolution.steps);
  transient.seconds = stopwatch.seconds();
  return transient;
}

}  // namespace fpkcheck::epc
