#include "epc/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "epc/contact/coordinates.hpp"
#include "epc/formulations.hpp"
#include "epc/half_plane/transient.hpp"
#include "epc/solve.hpp"
#include "problem/motion_scales.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::epc {
namespace {

using half_plane::ClosureEvolution;
using half_plane::ClosureSnapshot;
using transform::Status;
using transform::TransientRequest;

// Smallest deviations of the initial density, relative to the stationary deviations and to the root
// mean square of an impulse.
constexpr double kOfStationary = 0.3, kOfImpulse = 0.5;

std::string narrow_start_reason(const problem::Problem& problem,
                                const problem::MotionScales& scales, const problem::Gaussian& start,
                                const Options& options) {
  const bool has_impulses =
      effective_equation(options) != DensityEquation::white && problem.impulses.is_present();
  const double impulse =
      has_impulses
          ? std::sqrt(problem.impulses.rate_times_moment(2) / problem.impulses.arrival_rate())
          : 0;
  const double least_y = kOfStationary * scales.displacement_deviation;
  const double least_v = std::max(kOfStationary * scales.velocity_deviation, kOfImpulse * impulse);
  if (start.displacement_deviation >= least_y && start.velocity_deviation >= least_v) return "";
  return fmt::format(
      "the initial density is too narrow for a closure: deviations {:.3g} and {:.3g}; use at least "
      "{:.3g} and {:.3g}, or fd and mcs",
      start.displacement_deviation, start.velocity_deviation, least_y, least_v);
}

std::string transient_unsupported_reason(const problem::Problem& problem, const Options& options) {
  if (options.formulation == Formulation::gaussian) {
    return "the closure over time needs the formulation moment or polar";
  }
  if (options.formulation == Formulation::polar && contact::force_presses_on_single_wall(problem)) {
    return "the closure over time supports no mass at rest in contact; use fd or mcs";
  }
  return unsupported_reason(problem, options);
}

ClosureEvolution evolve(const problem::Problem& problem, const Options& options,
                        const problem::Gaussian& start, const std::vector<double>& times) {
  return options.formulation == Formulation::moment ? moment::evolve(problem, options, start, times)
                                                    : polar::evolve(problem, options, start, times);
}

transform::TransientSnapshot make_transient_snapshot(const problem::Problem& problem,
                                                     const ClosureSnapshot& closure,
                                                     const TransientRequest& request) {
  const transform::Density density =
      transform::to_physical_coordinates(problem.frame, closure.density);
  return {.time = closure.time,
          .moments = closure.moments,
          .y = transform::marginal(density, transform::StateVariable::y, request.y_edges),
          .ydot = transform::marginal(density, transform::StateVariable::ydot, request.v_edges)};
}

transform::ErrorEstimate difference_of_orders(const transform::TransientSnapshot& snapshot,
                                              const transform::TransientSnapshot& previous) {
  transform::ErrorEstimate difference{.y_l1 = l1(snapshot.y, previous.y),
                                      .ydot_l1 = l1(snapshot.ydot, previous.ydot)};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    difference.moments.*moment = std::abs(snapshot.moments.*moment - previous.moments.*moment);
  }
  return difference;
}

void increase_to(double& value, double other) { value = std::max(value, other); }

// Stores error estimates: the largest differences from order n-2 within half a period before and
// after each snapshot, or at the neighbouring snapshots. The difference at one time may be 0 by
// chance, since the differences oscillate.
// @param differences differences at the first snapshots
void store_error_estimates(const std::vector<transform::ErrorEstimate>& differences,
                           double half_period,
                           std::vector<transform::TransientSnapshot>& snapshots) {
  for (std::size_t k = 0; k < differences.size(); ++k) {
    transform::ErrorEstimate& error = snapshots[k].error.emplace(differences[k]);
    for (std::size_t j = 0; j < differences.size(); ++j) {
      const bool is_neighbour = j + 1 >= k && j <= k + 1;
      if (!is_neighbour && std::abs(snapshots[j].time - snapshots[k].time) > half_period) continue;
      increase_to(error.y_l1, differences[j].y_l1);
      increase_to(error.ydot_l1, differences[j].ydot_l1);
      for (const auto& [name, symbol, moment, size] : transform::kMoments) {
        increase_to(error.moments.*moment, differences[j].moments.*moment);
      }
    }
  }
}

}  // namespace

transform::Transient solve_transient(const problem::Problem& problem, const Options& options,
                                     const TransientRequest& request) {
  validate(options);
  const auto begin = std::chrono::steady_clock::now();
  transform::Transient transient{.id = id(options)};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const problem::MotionScales scales = problem::scales(transformed);
  const problem::Gaussian start = problem::initial_density(transformed, scales, request.start);
  transient.reason = transient_unsupported_reason(transformed, options);
  if (transient.reason.empty()) {
    transient.reason = narrow_start_reason(transformed, scales, start, options);
  }
  if (!transient.reason.empty()) {
    transient.status = Status::not_offered;
    return transient;
  }
  std::vector<double> times;
  for (int k = 0; k <= request.snapshots; ++k) times.push_back(request.time(k));
  const ClosureEvolution evolution = evolve(transformed, options, start, times);
  ClosureEvolution previous;
  if (options.order > 2) {
    Options lower = options;
    lower.order -= 2;
    previous = evolve(transformed, lower, start, times);
  }
  std::vector<transform::ErrorEstimate> differences;
  for (std::size_t k = 0; k < evolution.snapshots.size(); ++k) {
    transient.snapshots.push_back(
        make_transient_snapshot(transformed, evolution.snapshots[k], request));
    if (k < previous.snapshots.size()) {
      differences.push_back(difference_of_orders(
          transient.snapshots.back(),
          make_transient_snapshot(transformed, previous.snapshots[k], request)));
    }
  }
  store_error_estimates(differences, std::numbers::pi / scales.frequency, transient.snapshots);
  transient.status = evolution.status;
  transient.reason = evolution.reason;
  transient.details = fmt::format("{} x {} quadrature points, {} steps", evolution.quadrature.s,
                                  evolution.quadrature.t, evolution.steps);
  transient.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return transient;
}

}  // namespace fpkcheck::epc
