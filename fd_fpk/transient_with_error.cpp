#include "fd_fpk/transient_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <numbers>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/applicability.hpp"
#include "fd_fpk/transient.hpp"
#include "problem/motion_scales.hpp"
#include "transform/conservative_remap.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::TransientRequest;

// Ratios of coarse to fine solution: grid refinements and tolerances of the time steps.
constexpr double kCoarsening = 0.7, kToleranceRatio = 10;

// Tolerance of the time steps for a periodic state, whose search integrates over many periods. In
// case 1 under the force 0.3 cos(1.2 t) the estimated error is 3.5e-3 with the tolerance 3e-6, and
// 1.8e-3 with the tolerance 1e-6, which requires about 1.5 times as many time steps.
constexpr double kPeriodicTolerance = 3e-6;

transform::Marginal averages_over_bins(const std::vector<double>& cell_edges,
                                       const std::vector<double>& cell_averages,
                                       const std::vector<double>& edges) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < cell_averages.size(); ++i) {
    masses.push_back(cell_averages[i] * (cell_edges[i + 1] - cell_edges[i]));
  }
  transform::Marginal marginal{.edges = edges,
                               .density = transform::ConservativeRemap(cell_edges, edges)(masses),
                               .lower = {},
                               .upper = {}};
  for (std::size_t b = 0; b < marginal.size(); ++b) marginal.density[b] /= marginal.bin_width(b);
  return marginal;
}

std::vector<transform::TransientDensitySnapshot> make_transient_snapshots(
    const TransientResult& result, const TransientRequest& request) {
  std::vector<transform::TransientDensitySnapshot> snapshots;
  for (const DensitySnapshot& at : result.snapshots) {
    snapshots.push_back({.time = at.time,
                         .moments = at.moments,
                         .y = averages_over_bins(result.y_edges, at.y, request.y_edges),
                         .ydot = averages_over_bins(result.v_edges, at.v, request.v_edges)});
  }
  return snapshots;
}

}  // namespace

transform::TransientDensities solve_transient_with_error(const problem::Problem& problem,
                                                         const FiniteVolumeOptions& options,
                                                         const TransientRequest& request) {
  transform::TransientDensities transient{.id = solution_identity(options).id};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system),
                                   problem::with_largest_excitation(problem, request.time_span()));
  transient.reason = transient_unsupported_reason(transformed, options);
  if (!transient.reason.empty()) {
    transient.status = transform::Status::not_offered;
    return transient;
  }
  const base::Stopwatch stopwatch;
  TransientOptions on_fine{.until = request.until,
                           .snapshots = request.snapshots,
                           .start_displacement = request.start.displacement_deviation,
                           .start_velocity = request.start.velocity_deviation,
                           .start_mean_displacement = request.start.mean_displacement,
                           .start_mean_velocity = request.start.mean_velocity,
                           .periodic = request.periodic};
  if (request.periodic) on_fine.relative_tolerance = kPeriodicTolerance;
  const auto remaining_seconds = [&] {
    constexpr double kShortest = 0.1;
    return std::max(kShortest, options.max_seconds - stopwatch.seconds());
  };
  const auto solve_coarser = [&](double coarsening, double tolerance_ratio,
                                 const TransientResult* on_coarser_grid) {
    TransientOptions on_coarse = on_fine;
    on_coarse.relative_tolerance *= tolerance_ratio;
    on_coarse.max_cells *= coarsening * coarsening;
    on_coarse.continues_if_inadmissible = true;
    if (on_coarser_grid) on_coarse.periodic_guess = &*on_coarser_grid->periodic_state;
    FiniteVolumeOptions coarser = options;
    coarser.refinement *= coarsening;
    if (request.periodic) coarser.max_seconds = remaining_seconds();
    return solve_transient(problem, coarser, on_coarse);
  };
  TransientResult coarse, fine;
  if (request.periodic) {
    // The search for the periodic state on each grid starts from the periodic state on the next
    // coarser grid.
    const TransientResult coarsest =
        solve_coarser(kCoarsening * kCoarsening, kToleranceRatio * kToleranceRatio, nullptr);
    if (coarsest.periodic_state) coarse = solve_coarser(kCoarsening, kToleranceRatio, &coarsest);
    if (!coarse.periodic_state) {
      const TransientResult& last = coarsest.periodic_state ? coarse : coarsest;
      transient.status = last.status;
      transient.reason = fmt::format("on a coarse grid: {}", last.reason);
      transient.seconds = stopwatch.seconds();
      return transient;
    }
    on_fine.periodic_guess = &*coarse.periodic_state;
    FiniteVolumeOptions in_remaining_time = options;
    in_remaining_time.max_seconds = remaining_seconds();
    fine = solve_transient(problem, in_remaining_time, on_fine);
  } else {
    auto coarse_solution = std::async(
        std::launch::async, [&] { return solve_coarser(kCoarsening, kToleranceRatio, nullptr); });
    fine = solve_transient(problem, options, on_fine);
    coarse = coarse_solution.get();
  }
  transient.snapshots = make_transient_snapshots(fine, request);
  transform::estimate_errors_by_differences(
      make_transient_snapshots(coarse, request),
      std::numbers::pi / problem::motion_scales(transformed).frequency, transient.snapshots);
  // The coarse and the fine grid have nearly the same distance to the periodic state.
  for (transform::TransientDensitySnapshot& s : transient.snapshots) {
    if (!s.error) continue;
    s.error->y_l1 += fine.distance_to_periodic_state;
    s.error->ydot_l1 += fine.distance_to_periodic_state;
  }
  transient.status = fine.status;
  transient.reason = fine.reason;
  if (!fine.y_edges.empty()) {
    transient.details = fmt::format("{} x {} cells, {} steps", fine.y_edges.size() - 1,
                                    fine.v_edges.size() - 1, fine.steps);
    if (fine.periods > 0) {
      transient.details += fmt::format(", {} periods to an L1 change of {:.0e} per period",
                                       fine.periods, fine.change_over_period);
    }
  }
  transient.seconds = stopwatch.seconds();
  return transient;
}

}  // namespace fpkcheck::fd_fpk
