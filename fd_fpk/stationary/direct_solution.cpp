#include "fd_fpk/stationary/direct_solution.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/status_checks.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Largest accepted ratio of the stationarity residual after GMRES to the stationarity residual of
// the initial density.
constexpr double kLeastReduction = 1e-4;

DirectStationarySolution solve_on_grid(const problem::Problem& problem,
                                       const problem::MotionScales& scales,
                                       const FiniteVolumeOptions& options, const PhasePlaneBox& box,
                                       const base::Deadline& deadline) {
  PlaneDiscretisation discretisation = discretise_density_equation(problem, options, box);
  if (!discretisation.failure.empty()) {
    std::string failure = discretisation.failure;
    return {.discretisation = std::move(discretisation),
            .scales = scales,
            .failure = std::move(failure)};
  }
  const PhasePlaneGrid& grid = discretisation.grid;
  // The Fokker-Planck operator and the factors of its preconditioner are independent, so that two
  // threads compute operator and factors in parallel. The function find_null_vector() reports a
  // failed factorisation.
  FokkerPlanckOperator op;
  std::optional<Preconditioner> preconditioner;
  base::parallel_for(2, base::kOneThreadPerProcessor, [&](std::size_t part) {
    if (part == 0) {
      preconditioner.emplace(problem.system, scales.slowest_decay_rate, discretisation.excitation,
                             options.impact, grid, transport_order(options));
      preconditioner->factorise_stationary();
    } else {
      op = fokker_planck_operator(problem, options, discretisation);
    }
  });
  const Eigen::VectorXd start = initial_gaussian(grid, scales);
  auto [averages, iterations, failure, krylov_seconds] =
      find_null_vector(op, *preconditioner, start, deadline);
  const bool converged = averages && op.stationarity_residual(*averages) <
                                         kLeastReduction * op.stationarity_residual(start);
  return {.discretisation = std::move(discretisation),
          .scales = scales,
          .refinement = options.refinement,
          .origin_refinement = effective_origin_refinement(problem, options),
          .op = std::move(op),
          .preconditioner = std::move(preconditioner),
          .averages = std::move(averages),
          .converged = converged,
          .krylov_iterations = iterations,
          .failure = std::move(failure),
          .krylov_seconds = krylov_seconds};
}

enum class BoxLengthScaleSource { given, of_density };

// Computes the stationary density in a computational box whose free ends move outwards until the
// density at the free ends is negligible. After the deadline, free ends of the computational box
// with an acceptable density are not moved. With BoxLengthScaleSource::of_density the cell widths
// follow the length scales of the density. Standard deviations overestimate the length scales of a
// density with several peaks or a ring, and wide cells would smooth the tails.
DirectStationarySolution solve_in_wide_enough_box(
    const problem::Problem& problem, const problem::MotionScales& scales,
    const FiniteVolumeOptions& options, const base::Deadline& deadline, PhasePlaneBox& box,
    BoxLengthScaleSource lengths = BoxLengthScaleSource::given) {
  constexpr double kWidening = 1.15;
  constexpr double kFall = 1.5;
  // Approximate ratio of the computing times in an enlarged and in the previous computational box
  constexpr double kTimeRatio = 1.5;
  constexpr int kMostUpdates = 3;
  constexpr double kSame = 0.9;
  int updates = 0;
  BoxEdgeDensity last{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  while (true) {
    const base::Stopwatch stopwatch;
    DirectStationarySolution direct = solve_on_grid(problem, scales, options, box, deadline);
    if (!direct.averages || !direct.converged) return direct;
    if (lengths == BoxLengthScaleSource::of_density) {
      const DensityLengthScales before = std::exchange(
          box.lengths, fisher_length_scales(problem.system, box, direct.discretisation.grid,
                                            *direct.averages, scales));
      if (box.lengths.x1 < kSame * before.x1 || box.lengths.x2 < kSame * before.x2) {
        box.lengths = {std::min(box.lengths.x1, before.x1), std::min(box.lengths.x2, before.x2)};
        if (updates++ < kMostUpdates) continue;
      }
    }
    const BoxEdgeDensity wall =
        relative_box_edge_density(scales, direct.discretisation.grid, *direct.averages);
    // If the density at an end of the computational box does not decrease when the end moves
    // outwards, this density is a discretisation error.
    const bool widen_x1 =
        !options.x1_max && wall.x1 > options.wall_density && wall.x1 < last.x1 / kFall;
    const bool widen_x2 =
        !options.x2_max && wall.x2 > options.wall_density && wall.x2 < last.x2 / kFall;
    const bool widen_x1_low =
        !options.x1_max && wall.x1_low > options.wall_density && wall.x1_low < last.x1_low / kFall;
    if (!widen_x1 && !widen_x2 && !widen_x1_low) return direct;
    const bool is_acceptable = wall.x1 <= kMaxBoxEdgeDensity && wall.x2 <= kMaxBoxEdgeDensity &&
                               wall.x1_low <= kMaxBoxEdgeDensity;
    if (is_acceptable && !deadline.has_time_for(kTimeRatio * stopwatch.seconds())) return direct;
    if (problem.system.left_wall()) {
      if (widen_x1) box.x1_max *= kWidening;
    } else {  // a box without an impact wall is widened about its middle
      const double by = (kWidening - 1) * (box.x1_max - box.x1_min) / 2;
      if (widen_x1) box.x1_max += by;
      if (widen_x1_low) box.x1_min -= by;
    }
    if (widen_x2) box.x2_max *= kWidening;
    // The variable `last` contains the density at each end of the computational box before its last
    // move.
    if (widen_x1) last.x1 = wall.x1;
    if (widen_x2) last.x2 = wall.x2;
    if (widen_x1_low) last.x1_low = wall.x1_low;
  }
}

bool is_resolved(const problem::Problem& problem, const FiniteVolumeOptions& options,
                 const DirectStationarySolution& direct) {
  const Eigen::VectorXd& averages = *direct.averages;
  const double energy = power_balance_residual(problem, options.impact, direct.discretisation.grid,
                                               averages, transport_order(options));
  return kAutomaticGridResolutionLimits.is_density_accepted(averages.minCoeff() /
                                                            averages.maxCoeff()) &&
         kAutomaticGridResolutionLimits.is_power_residual_accepted(energy);
}

}  // namespace

PhasePlaneBox stationary_box(const problem::Problem& problem, const problem::MotionScales& scales,
                             const FiniteVolumeOptions& options, const base::Deadline& deadline) {
  constexpr double kCoarse = 0.5;
  PhasePlaneBox box = initial_box(problem, scales, options);
  const bool are_lengths_needed = !has_linearised_scales(problem);
  if (!options.x1_max || !options.x2_max || are_lengths_needed) {
    FiniteVolumeOptions coarse = options;
    coarse.nx = coarse.nv = std::nullopt;
    coarse.refinement = kCoarse * kCellWidthFactorOfHighOrder;
    coarse.order =
        kHighFiniteVolumeOrder;  // schemes of lower order smooth the tails on a coarse grid
    coarse.origin_refinement = 1;
    solve_in_wide_enough_box(
        problem, scales, coarse, deadline, box,
        are_lengths_needed ? BoxLengthScaleSource::of_density : BoxLengthScaleSource::given);
  }
  return box;
}

DirectStationarySolution compute_direct_solution(
    const problem::Problem& problem, const MotionScalesAndComputationalBox& scales_and_box,
    const FiniteVolumeOptions& options, const base::Deadline& deadline) {
  constexpr int kRefinements = 2;
  // Largest number of cells of a grid that is refined; refining a larger grid takes minutes
  constexpr int kMostCellsRefined = 8000;
  constexpr double kRefinement = 1.5;
  // Approximate ratio of the computing times on the refined and the previous grid
  constexpr double kTimeRatio = 5;
  const problem::MotionScales& scales = scales_and_box.scales;
  PhasePlaneBox box =
      scales_and_box.box ? *scales_and_box.box : stationary_box(problem, scales, options, deadline);
  FiniteVolumeOptions on_grid = options;
  std::optional<DirectStationarySolution> coarser;
  for (int refinement = 0;; ++refinement) {
    const base::Stopwatch stopwatch;
    DirectStationarySolution direct =
        solve_in_wide_enough_box(problem, scales, on_grid, deadline, box);
    if (coarser && !direct.averages && deadline.has_deadline_passed()) return std::move(*coarser);
    const bool automatic = options.refine_unresolved && !options.nx && !options.nv;
    if (!direct.averages || !direct.converged || !automatic || refinement == kRefinements ||
        direct.discretisation.grid.size() > kMostCellsRefined ||
        !deadline.has_time_for(kTimeRatio * stopwatch.seconds()) ||
        is_resolved(problem, options, direct) ||
        has_negative_density_on_all_grids(
            options, direct.averages->minCoeff() / direct.averages->maxCoeff())) {
      return direct;
    }
    // If the density has a spike at the origin, the first refinement refines only the cells at the
    // spike.
    if (is_density_unbounded_at_origin(problem) && direct.origin_refinement < kOriginRefinement) {
      on_grid.origin_refinement = kOriginRefinement;
    } else {
      on_grid.refinement *= kRefinement;
    }
    coarser = std::move(direct);
  }
}

}  // namespace fpkcheck::fd_fpk
