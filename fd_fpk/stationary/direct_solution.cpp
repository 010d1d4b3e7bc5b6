#include "fd_fpk/stationary/direct_solution.hpp"

#include <algorithm>
#include <cmath>

#include "fd_fpk/linear/null_vector.hpp"
#include "fd_fpk/operator/observables.hpp"
#include "fd_fpk/operator/resolution.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Of the residual, by GMRES.
constexpr double kLeastReduction = 1e-4;

DirectSolution solve_in(const problem::Problem& problem, const Options& options, const Box& box,
                        const Deadline& given_up) {
  Discretisation discretisation = discretise(problem, options, box);
  if (!discretisation.refusal.empty()) {
    std::string refusal = discretisation.refusal;
    return {.discretisation = std::move(discretisation), .failure = std::move(refusal)};
  }
  const Grid& grid = discretisation.grid;
  FokkerPlanckOperator op = fokker_planck_operator(problem, options, discretisation);
  Preconditioner preconditioner(problem, discretisation.excitation, options.impact, grid,
                                options.order);
  const Eigen::VectorXd start = gaussian_start(grid, problem);
  auto [averages, iterations, failure, krylov_seconds] =
      null_vector(op, preconditioner, start, given_up);
  const bool converged = averages && op.residual(*averages) < kLeastReduction * op.residual(start);
  return {.discretisation = std::move(discretisation),
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

// Solves in `box` and moves the walls of it that the options leave free until they are empty, or,
// when the time is over, until the box is not too small to be an answer.
DirectSolution solve_in_wide_enough_box(const problem::Problem& problem, const Options& options,
                                        const Deadline& deadline, Answer so_far, Box& box) {
  constexpr double kWidening = 1.15;
  constexpr double kFall = 1.5;
  constexpr double kSlower = 1.5;  // the wider box, about
  WallDensity last{HUGE_VAL, HUGE_VAL};
  while (true) {
    const Stopwatch stopwatch;
    DirectSolution direct = solve_in(problem, options, box, giving_up(deadline, so_far));
    if (!direct.averages || !direct.converged) return direct;
    const WallDensity wall =
        relative_wall_density(problem, direct.discretisation.grid, *direct.averages);
    // A wall whose density does not fall when it moves shows the grid's own error, not a tail.
    const bool widen_x1 =
        !options.x1_max && wall.x1 > options.wall_density && wall.x1 < last.x1 / kFall;
    const bool widen_x2 =
        !options.x2_max && wall.x2 > options.wall_density && wall.x2 < last.x2 / kFall;
    if (!widen_x1 && !widen_x2) return direct;
    const bool will_do = wall.x1 <= kMostOnWall && wall.x2 <= kMostOnWall;
    if (will_do && !deadline.allows(kSlower * stopwatch.seconds())) return direct;
    if (widen_x1) box.x1_max *= kWidening;
    if (widen_x2) box.x2_max *= kWidening;
    last = wall;
  }
}

bool resolved(const problem::Problem& problem, const Options& options,
              const DirectSolution& direct) {
  const Eigen::VectorXd& averages = *direct.averages;
  const double energy =
      energy_residual(problem, options.impact, direct.discretisation.grid, averages, options.order);
  return kAutomaticGridBars.allow_density(averages.minCoeff() / averages.maxCoeff()) &&
         kAutomaticGridBars.allow_imbalance(energy);
}

}  // namespace

Box stationary_box(const problem::Problem& problem, const Options& options,
                   const Deadline& deadline, Answer so_far) {
  constexpr double kCoarse = 0.5;
  constexpr int kCoarseOrder = 7;  // lower ones smear tails on such a grid
  Box box = initial_box(problem, options);
  if (!options.x1_max || !options.x2_max) {
    Options coarse = options;
    coarse.nx = coarse.nv = std::nullopt;
    coarse.refinement = kCoarse;
    coarse.order = kCoarseOrder;
    coarse.origin_refinement = 1;
    solve_in_wide_enough_box(problem, coarse, deadline, so_far, box);
  }
  return box;
}

DirectSolution solve_directly(const problem::Problem& problem, const Options& options,
                              const Deadline& deadline, Answer so_far) {
  constexpr int kRefinements = 2;
  constexpr int kMostCellsRefined = 8000;  // of the first grid; finer ones take minutes
  constexpr double kRefinement = 1.5;
  constexpr double kSlower = 5;  // a grid so much finer, about
  Box box = stationary_box(problem, options, deadline, so_far);
  Options on_grid = options;
  std::optional<DirectSolution> coarser;
  for (int refinement = 0;; ++refinement) {
    const Stopwatch stopwatch;
    DirectSolution direct = solve_in_wide_enough_box(problem, on_grid, deadline,
                                                     coarser ? Answer::stands : so_far, box);
    if (coarser && !direct.averages && deadline.is_over()) return std::move(*coarser);
    const bool automatic = options.refine_unresolved && !options.nx && !options.nv;
    if (!direct.averages || !direct.converged || !automatic || refinement == kRefinements ||
        direct.discretisation.grid.size() > kMostCellsRefined ||
        !deadline.allows(kSlower * stopwatch.seconds()) || resolved(problem, options, direct)) {
      return direct;
    }
    // What is not resolved of a spike is the spike.
    if (unbounded_at_origin(problem) && direct.origin_refinement < kRefinedOrigin) {
      on_grid.origin_refinement = kRefinedOrigin;
    } else {
      on_grid.refinement *= kRefinement;
    }
    coarser = std::move(direct);
  }
}

}  // namespace fpkcheck::fd_fpk
