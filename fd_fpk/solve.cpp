#include "fd_fpk/solve.hpp"

#include "fd_fpk/stationary/error_estimate.hpp"
#include "fd_fpk/stationary/one_grid.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const Stopwatch stopwatch;
  const auto on_one_grid = [&](const Options& grid) { return solve_on_one_grid(problem, grid); };
  Result result = options.tolerance        ? solve_to_tolerance(on_one_grid, options)
                  : options.error_estimate ? solve_with_error_estimate(on_one_grid, options)
                                           : on_one_grid(options);
  auto& [solution, summary] = result;
  solution.seconds = stopwatch.seconds();
  solution.identity = identity(options);
  if (const auto& error = summary.error) {
    solution.error = {error->y_l1, error->ydot_l1, error->moments};
  }
  solution.observations = observations(summary);
  return result;
}

}  // namespace fpkcheck::fd_fpk
