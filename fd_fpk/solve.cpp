#include "fd_fpk/solve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "fd_fpk/direct_solution.hpp"
#include "fd_fpk/discretisation.hpp"
#include "fd_fpk/error_estimate.hpp"
#include "fd_fpk/null_vector.hpp"
#include "fd_fpk/observables.hpp"
#include "fd_fpk/pseudo_transient.hpp"
#include "fd_fpk/well_posedness.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Density on the wall, relative to the peak, above which no box is accepted.
constexpr double kTooMuch = 1e-3;
// First and longest CVODE step, in units of the oscillator's radian and of its slowest decay time.
// Rounding in (I - gamma L)^-1 moves mass by about 1e-15 gamma ||L||, hence the bound.
constexpr double kFirstStep = 10;
constexpr double kLongestStep = 500;

// A density that falls below this share of its peak, or misses the power balance by more, is not
// resolved by its grid.
constexpr double kMostNegative = -1e-4;
constexpr double kEnergyAllowed = 1e-3;

// The density by the chosen stepper; empty when there is none. Fills in the status.
std::optional<Eigen::VectorXd> stationary_density(DirectSolution& direct,
                                                  const problem::Problem& problem,
                                                  const Options& options, Result& result) {
  auto& [solution, summary] = result;
  if (!direct.averages) {
    solution.status = Status::failed;
    solution.reason = direct.failure;
    return std::nullopt;
  }
  const auto linear = problem::equivalent_linearisation(problem);
  const double frequency = std::sqrt(linear.stiffness);
  std::optional<Eigen::VectorXd> averages;
  if (options.stepper == Stepper::direct) {
    summary.factorisations = 1;
    summary.krylov_iterations = direct.krylov_iterations;
    summary.factor_seconds = direct.preconditioner->factor_seconds();
    summary.krylov_seconds = direct.krylov_seconds;
    summary.residual = direct.op.residual(*direct.averages) / frequency;
    averages = direct.averages;
  } else {
    March march = march_to_stationarity(
        direct.op, *direct.preconditioner, gaussian_start(direct.discretisation.grid, problem),
        options.residual_tolerance * frequency,
        {.first_step = kFirstStep / frequency,
         .longest_step = kLongestStep / problem::slowest_decay(linear)});
    summary.steps = march.steps;
    summary.factorisations = march.factorisations;
    summary.rhs_evaluations = march.rhs_evaluations;
    summary.krylov_iterations = march.krylov_iterations;
    summary.factor_seconds = march.factor_seconds;
    summary.krylov_seconds = march.krylov_seconds;
    summary.residual = march.residual / frequency;
    summary.stepped_against_direct =
        (march.averages - *direct.averages).cwiseAbs().maxCoeff() / direct.averages->maxCoeff();
    solution.reason = march.reason;
    if (march.averages.allFinite()) averages = std::move(march.averages);
  }
  solution.status = Status::ok;
  if (!(summary.residual <= options.residual_tolerance)) {
    solution.status = Status::not_converged;
    if (solution.reason.empty()) {
      solution.reason = fmt::format(
          "residual {:.1e} after {} steps and {} factorisations, {:.1e} was asked for",
          summary.residual, summary.steps, summary.factorisations, options.residual_tolerance);
    }
  }
  return averages;
}

void require_empty_walls(const Grid& grid, Result& result) {
  auto& [solution, summary] = result;
  const auto& wall = summary.wall;
  if (solution.status != Status::ok || (wall.x1 <= kTooMuch && wall.x2 <= kTooMuch)) return;
  solution.status = Status::failed;
  solution.reason = fmt::format(
      "the box y <= {:.3g}, |y'| <= {:.3g} is too small: the density on its wall is {:.1e} of "
      "the peak (widen it)",
      grid.x1_max(), grid.x2_max(), std::max(wall.x1, wall.x2));
}

void require_resolved(transform::Solution& solution) {
  if (solution.status != Status::ok) return;
  if (solution.min_density < kMostNegative) {
    const bool first_order_impact = solution.impact == problem::Impact::delta;
    solution.reason = fmt::format(
        "the density is negative down to {:.1g} of its peak: {}", solution.min_density,
        first_order_impact ? "the grid does not resolve it, or the impact to first order in 1-r, "
                             "which keeps no sign, has no density (compare with a finer grid)"
                           : "the grid does not resolve it (refine with nx and nv)");
  } else if (std::abs(solution.energy_residual) > kEnergyAllowed) {
    solution.reason = fmt::format(
        "the balance of power is missed by {:.1g} of the input: the grid does not resolve the "
        "density (refine with nx and nv)",
        solution.energy_residual);
  }
  if (!solution.reason.empty()) solution.status = Status::inadmissible;
}

void observe(const problem::Problem& problem, const Grid& grid, const Eigen::VectorXd& averages,
             int order, Result& result) {
  auto& [solution, summary] = result;
  solution.density = grid_density(grid, averages);
  solution.moments = moments(grid, averages, order);
  solution.mass = grid.areas().dot(averages);
  solution.min_density = averages.minCoeff() / averages.maxCoeff();
  summary.wall = relative_wall_density(problem, grid, averages);
  summary.impact_rate = impact_flux(grid, averages, order, 1);
  solution.energy_residual = energy_residual(problem, solution.impact, grid, averages, order);
}

void describe(const Discretisation& discretisation, Summary& summary) {
  const Grid& grid = discretisation.grid;
  summary.nx = grid.nx();
  summary.nv = grid.nv();
  summary.x1_max = grid.x1_max();
  summary.x2_max = grid.x2_max();
  summary.regularisation_length = discretisation.regularisation_length;
}

Result solve_on_one_grid(const problem::Problem& problem, const Options& options) {
  Result result;
  auto& [solution, summary] = result;
  solution.id = id(options);
  solution.method = "fd";
  solution.equation = name(options.equation);
  solution.impact = options.impact;

  // Growth depends on the velocity step alone, so it is judged before anything is solved.
  const auto first = discretise(problem, options, initial_box(problem, options));
  describe(first, summary);
  if (!first.refusal.empty()) {
    solution.status = Status::failed;
    solution.reason = first.refusal;
    return result;
  }
  const auto [growth, ill_posed] = posedness(problem, options, first);
  summary.growth_rate = growth.rate;
  summary.growth_wavenumber = growth.wavenumber;
  if (!ill_posed.empty()) {
    solution.status = Status::ill_posed;
    solution.reason = ill_posed;
    return result;
  }

  DirectSolution direct = solve_directly(problem, options);
  describe(direct.discretisation, summary);
  summary.refinement = direct.refinement;
  summary.origin_refinement = direct.origin_refinement;
  if (direct.averages) {
    summary.nonzeros = direct.op.local.nonZeros();
    summary.leak = direct.op.leak();
    summary.factor_entries = direct.preconditioner->entries();
  }
  const auto density = stationary_density(direct, problem, options, result);
  if (density) {
    const Grid& grid = direct.discretisation.grid;
    observe(problem, grid, *density, options.order, result);
    require_empty_walls(grid, result);
    require_resolved(result.solution);
  }
  return result;
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const auto begin = std::chrono::steady_clock::now();
  const auto on_one_grid = [&](const Options& grid) { return solve_on_one_grid(problem, grid); };
  Result result = options.tolerance        ? solve_to_tolerance(on_one_grid, options)
                  : options.error_estimate ? solve_with_error_estimate(on_one_grid, options)
                                           : on_one_grid(options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  result.solution.seconds = elapsed.count();
  return result;
}

}  // namespace fpkcheck::fd_fpk
