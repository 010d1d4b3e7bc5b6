#include "fd_fpk/direct_solution.hpp"

#include <cmath>

#include "fd_fpk/null_vector.hpp"
#include "fd_fpk/observables.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

DirectSolution solve_directly(const problem::Problem& problem, const Options& options,
                              const Box& box) {
  Discretisation discretisation = discretise(problem, options, box);
  if (!discretisation.refusal.empty()) {
    std::string refusal = discretisation.refusal;
    return {.discretisation = std::move(discretisation), .failure = std::move(refusal)};
  }
  const Grid& grid = discretisation.grid;
  SparseColumns matrix =
      fokker_planck_operator(problem.system, discretisation.excitation, grid, options.order);
  auto [averages, failure] =
      null_vector(matrix, grid, gaussian_start(grid, problem),
                  problem::slowest_decay(problem::equivalent_linearisation(problem)));
  return {std::move(discretisation), std::move(matrix), std::move(averages), std::move(failure)};
}

}  // namespace

DirectSolution solve_in_wide_enough_box(const problem::Problem& problem, const Options& options) {
  constexpr double kNegligible = 1e-6;  // of the peak, on a wall
  constexpr double kWidening = 1.25;
  Box box = initial_box(problem, options);
  WallDensity last{HUGE_VAL, HUGE_VAL};
  while (true) {
    DirectSolution direct = solve_directly(problem, options, box);
    if (!direct.averages) return direct;
    const WallDensity wall = wall_density(direct.discretisation.grid, *direct.averages);
    // A wall whose density does not fall when it moves shows the grid's own error, not a tail.
    const bool widen_x1 = !options.x1_max && wall.x1 > kNegligible && wall.x1 < last.x1 / 2;
    const bool widen_x2 = !options.x2_max && wall.x2 > kNegligible && wall.x2 < last.x2 / 2;
    if (!widen_x1 && !widen_x2) return direct;
    if (widen_x1) box.x1_max *= kWidening;
    if (widen_x2) box.x2_max *= kWidening;
    last = wall;
  }
}

}  // namespace fpkcheck::fd_fpk
