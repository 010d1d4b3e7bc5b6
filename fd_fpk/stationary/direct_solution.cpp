#include "fd_fpk/stationary/direct_solution.hpp"

#include <algorithm>
#include <cmath>

#include "fd_fpk/linear/null_vector.hpp"
#include "fd_fpk/operator/observables.hpp"
#include "fd_fpk/operator/resolution.hpp"
#include "problem/features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Required reduction of the residual by GMRES.
constexpr double kLeastReduction = 1e-4;

DirectSolution solve_in(const problem::Problem& problem, const problem::Scales& scales,
                        const Options& options, const Box& box, const Deadline& deadline) {
  Discretisation discretisation = discretise(problem, options, box);
  if (!discretisation.refusal.empty()) {
    std::string refusal = discretisation.refusal;
    return {.discretisation = std::move(discretisation),
            .scales = scales,
            .failure = std::move(refusal)};
  }
  const Grid& grid = discretisation.grid;
  FokkerPlanckOperator op = fokker_planck_operator(problem, options, discretisation);
  Preconditioner preconditioner(problem.system, scales.slowest_decay, discretisation.excitation,
                                options.impact, grid, order_of(options));
  const Eigen::VectorXd start = gaussian_start(grid, problem, scales);
  auto [averages, iterations, failure, krylov_seconds] =
      null_vector(op, preconditioner, start, deadline);
  const bool converged = averages && op.residual(*averages) < kLeastReduction * op.residual(start);
  return {.discretisation = std::move(discretisation),
          .scales = scales,
          .refinement = options.refinement,
          .origin_refinement = origin_refinement(problem, options),
          .op = std::move(op),
          .preconditioner = std::move(preconditioner),
          .averages = std::move(averages),
          .converged = converged,
          .krylov_iterations = iterations,
          .failure = std::move(failure),
          .krylov_seconds = krylov_seconds};
}

// Solves in `box` and moves the walls that the options leave free until the density on them is
// negligible, or, at the deadline, until the box is acceptable.
DirectSolution solve_in_wide_enough_box(const problem::Problem& problem,
                                        const problem::Scales& scales, const Options& options,
                                        const Deadline& deadline, Box& box) {
  constexpr double kWidening = 1.15;
  constexpr double kFall = 1.5;
  constexpr double kSlower = 1.5;  // time ratio for the wider box, about
  WallDensity last{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  while (true) {
    const Stopwatch stopwatch;
    DirectSolution direct = solve_in(problem, scales, options, box, deadline);
    if (!direct.averages || !direct.converged) return direct;
    const WallDensity wall =
        relative_wall_density(scales, direct.discretisation.grid, *direct.averages);
    // A wall density that does not fall when the wall moves is a discretisation error, not a tail.
    const bool widen_x1 =
        !options.x1_max && wall.x1 > options.wall_density && wall.x1 < last.x1 / kFall;
    const bool widen_x2 =
        !options.x2_max && wall.x2 > options.wall_density && wall.x2 < last.x2 / kFall;
    const bool widen_x1_low =
        !options.x1_max && wall.x1_low > options.wall_density && wall.x1_low < last.x1_low / kFall;
    if (!widen_x1 && !widen_x2 && !widen_x1_low) return direct;
    const bool will_do =
        wall.x1 <= kMostOnWall && wall.x2 <= kMostOnWall && wall.x1_low <= kMostOnWall;
    if (will_do && !deadline.allows(kSlower * stopwatch.seconds())) return direct;
    if (problem.system.left()) {
      if (widen_x1) box.x1_max *= kWidening;
    } else {  // without an impact wall: about the middle
      const double by = (kWidening - 1) * (box.x1_max - box.x1_min) / 2;
      if (widen_x1) box.x1_max += by;
      if (widen_x1_low) box.x1_min -= by;
    }
    if (widen_x2) box.x2_max *= kWidening;
    last = wall;
  }
}

// Outside the paper's class standard deviations overestimate the length scales of a density. In
// several wells and on rings a grid based on them smears the density and causes ripples at the
// walls of the box. Grids based on the computed length scales follow, until these converge.
void find_box_and_lengths(const problem::Problem& problem, const problem::Scales& scales,
                          const Options& coarse, const Deadline& deadline, Box& box) {
  constexpr int kMostTimes = 4;
  constexpr double kSame = 0.9;
  const Box first = box;
  for (int time = 0; time < kMostTimes; ++time) {
    const Lengths before = box.lengths;
    box = first;
    box.lengths = before;
    const DirectSolution found = solve_in_wide_enough_box(problem, scales, coarse, deadline, box);
    if (!found.averages || !found.converged) return;
    box.lengths = lengths_of(found.discretisation.grid, *found.averages, scales);
    if (box.lengths.x1 >= kSame * before.x1 && box.lengths.x2 >= kSame * before.x2) return;
    box.lengths = {std::min(box.lengths.x1, before.x1), std::min(box.lengths.x2, before.x2)};
  }
}

bool resolved(const problem::Problem& problem, const Options& options,
              const DirectSolution& direct) {
  const Eigen::VectorXd& averages = *direct.averages;
  const double energy = energy_residual(problem, options.impact, direct.discretisation.grid,
                                        averages, order_of(options));
  return kAutomaticGridBars.allow_density(averages.minCoeff() / averages.maxCoeff()) &&
         kAutomaticGridBars.allow_imbalance(energy);
}

}  // namespace

Box stationary_box(const problem::Problem& problem, const Options& options,
                   const Deadline& deadline) {
  return stationary_box(problem, problem::scales(problem), options, deadline);
}

Box stationary_box(const problem::Problem& problem, const problem::Scales& scales,
                   const Options& options, const Deadline& deadline) {
  constexpr double kCoarse = 0.5;
  Box box = initial_box(problem, scales, options);
  const bool look_at_lengths = !problem::of_the_paper(problem);
  if (!options.x1_max || !options.x2_max || look_at_lengths) {
    Options coarse = options;
    coarse.nx = coarse.nv = std::nullopt;
    coarse.refinement = look_at_lengths ? kCoarse * kWidthOfHighOrder : kCoarse;
    coarse.order = kHighOrder;  // lower orders smear tails on such a grid
    coarse.origin_refinement = 1;
    if (look_at_lengths) {
      find_box_and_lengths(problem, scales, coarse, deadline, box);
    } else {
      solve_in_wide_enough_box(problem, scales, coarse, deadline, box);
    }
  }
  return box;
}

DirectSolution solve_directly(const problem::Problem& problem, const Surroundings& surroundings,
                              const Options& options, const Deadline& deadline) {
  constexpr int kRefinements = 2;
  constexpr int kMostCellsRefined = 8000;  // limit for the first grid; finer grids take minutes
  constexpr double kRefinement = 1.5;
  constexpr double kSlower = 5;  // time ratio for the refined grid, about
  const problem::Scales& scales = surroundings.scales;
  Box box =
      surroundings.box ? *surroundings.box : stationary_box(problem, scales, options, deadline);
  Options on_grid = options;
  std::optional<DirectSolution> coarser;
  for (int refinement = 0;; ++refinement) {
    const Stopwatch stopwatch;
    DirectSolution direct = solve_in_wide_enough_box(problem, scales, on_grid, deadline, box);
    if (coarser && !direct.averages && deadline.is_over()) return std::move(*coarser);
    const bool automatic = options.refine_unresolved && !options.nx && !options.nv;
    if (!direct.averages || !direct.converged || !automatic || refinement == kRefinements ||
        direct.discretisation.grid.size() > kMostCellsRefined ||
        !deadline.allows(kSlower * stopwatch.seconds()) || resolved(problem, options, direct)) {
      return direct;
    }
    // If the grid does not resolve the density, refine the spike first.
    if (unbounded_at_origin(problem) && direct.origin_refinement < kRefinedOrigin) {
      on_grid.origin_refinement = kRefinedOrigin;
    } else {
      on_grid.refinement *= kRefinement;
    }
    coarser = std::move(direct);
  }
}

}  // namespace fpkcheck::fd_fpk
