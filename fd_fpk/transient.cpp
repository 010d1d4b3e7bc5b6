#include "fd_fpk/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fd_fpk/linear/linear_cvode.hpp"
#include "fd_fpk/operator/observables.hpp"
#include "fd_fpk/operator/resolution.hpp"
#include "fd_fpk/operator/turning_point.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "parameters/input_error.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Deviations of the start that the box holds, and cells to one of them at least.
constexpr double kStartBox = 6;
constexpr double kStartCells = 5;

// The deviations of the start, after the options.
struct Start {
  double displacement;
  double velocity;
};

Start start_of(const problem::Problem& problem, const TransientOptions& transient) {
  constexpr double kDefault = 0.5;
  const auto linear = problem::equivalent_linearisation(problem);
  return {transient.start_displacement.value_or(kDefault * linear.displacement_deviation),
          transient.start_velocity.value_or(kDefault * linear.velocity_deviation)};
}

// Holds the stationary density, the start, and what a start at rest or at the wall turns into.
Box box_of(const problem::Problem& problem, const Options& options, const Start& start) {
  const auto& system = problem.system;
  Box box = stationary_box(problem, options, Deadline(options.max_seconds));
  const double y = kStartBox * start.displacement, v = kStartBox * start.velocity;
  if (!options.x1_max) box.x1_max = std::max({box.x1_max, y, turning_point(system, v * v / 2)});
  if (!options.x2_max) box.x2_max = std::max({box.x2_max, v, std::sqrt(2 * system.potential()(y))});
  return box;
}

// A start narrower than the stationary density wants narrower cells, in both directions: it turns.
Options resolving(const problem::Problem& problem, Options options, const Start& start) {
  constexpr double kCells = 6;  // of the automatic grid to a deviation
  const auto linear = problem::equivalent_linearisation(problem);
  const double narrowness = std::max(linear.displacement_deviation / start.displacement,
                                     linear.velocity_deviation / start.velocity);
  options.refinement *= std::max(1.0, narrowness * kStartCells / kCells);
  // Steps are short against the oscillation: the narrow cells of an automatic grading would make
  // the equations stiff for the sake of one point.
  options.origin_refinement = options.origin_refinement.value_or(1);
  return options;
}

Snapshot snapshot(const problem::Problem& problem, const Options& options, const Grid& grid,
                  const FokkerPlanckOperator& op, const Eigen::VectorXd& averages, double time) {
  Snapshot s{.time = time, .moments = moments(grid, averages, options.order)};
  s.energy = mean_energy(problem.system, grid, averages, options.order);
  const double energy_rate = mean_energy(problem.system, grid, op * averages, options.order);
  const auto [input, dissipated] =
      problem::power(problem, options.impact,
                     energy_terms(problem.system, s.moments, grid, averages, options.order));
  s.power = input - dissipated;
  s.power_residual = (s.power - energy_rate) / (problem.impulses.intensity() / 2);
  s.impact_rate = impact_flux(grid, averages, options.order, 1);
  s.mass = op.mass(averages);
  s.min_density = averages.minCoeff() / averages.maxCoeff();
  s.wall = relative_wall_density(problem, grid, averages);
  const auto [y, ydot] = marginals(grid, averages);
  s.y.assign(y.begin(), y.end());
  s.v.assign(ydot.begin(), ydot.end());
  return s;
}

// What is wrong with a density; fills in status and reason.
void judge(const Grid& grid, const Snapshot& at, TransientResult& result) {
  if (const auto objection = box_objection(grid, at.wall, fmt::format("at t = {:.4g} ", at.time));
      !objection.empty()) {
    result.status = Status::failed;
    result.reason = objection;
  } else if (!kBarsOverTime.allow_density(at.min_density)) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "at t = {:.4g} the density is negative down to {:.1g} of its peak: grid or time steps do not "
        "resolve it (refine, start wider, take order 3 or a smaller time tolerance)",
        at.time, at.min_density);
  } else if (!kBarsOverTime.allow_imbalance(at.power_residual)) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "at t = {:.4g} the balance of power is missed by {:.1g} of the input: the grid does not "
        "resolve the density (refine it, or start wider)",
        at.time, at.power_residual);
  }
}

void step_through(const problem::Problem& problem, const Options& options,
                  const TransientOptions& transient, const Grid& grid,
                  const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                  TransientResult& result) {
  constexpr long kMostSteps = 1000000;  // between two snapshots
  // Of the local error; the rest of it goes into mass that is lost.
  constexpr double kLinearTolerance = 1e-3;
  constexpr long kStepsPerFactorisation = 10000;  // L is constant: a new gamma is what asks for one

  const Eigen::VectorXd start =
      folded_gaussian(grid, result.start_displacement, result.start_velocity);
  LinearCvode cvode(linear_system(op, preconditioner), start,
                    {.max_order = transient.max_order,
                     .relative_tolerance = transient.relative_tolerance,
                     .absolute_tolerance = transient.relative_tolerance * start.maxCoeff(),
                     .linear_tolerance = kLinearTolerance,
                     .stop_time = transient.until,
                     .most_steps = kMostSteps,
                     .steps_per_factorisation = kStepsPerFactorisation});

  result.status = Status::ok;
  for (int n = 0; n <= transient.snapshots && result.status == Status::ok; ++n) {
    const double time =
        n == transient.snapshots ? transient.until : n * (transient.until / transient.snapshots);
    const auto [flag, reached] = n == 0 ? LinearCvode::Reached{0, 0} : cvode.advance(time);
    if (flag < 0) {
      result.status = Status::not_converged;
      result.reason = fmt::format("CVODE stopped at t = {:.4g} on the way to {:.4g} (flag {}): {}",
                                  reached, time, flag, cvode.message());
      break;
    }
    result.snapshots.push_back(snapshot(problem, options, grid, op, cvode.averages(), time));
    judge(grid, result.snapshots.back(), result);
    if (transient.progress) transient.progress(static_cast<double>(n) / transient.snapshots);
  }
  result.steps = cvode.steps();
  result.factorisations = cvode.factorisations();
  result.rhs_evaluations = cvode.rhs_evaluations();
  result.krylov_iterations = cvode.krylov_iterations();
}

TransientResult integrate_untimed(const problem::Problem& problem, const Options& options,
                                  const TransientOptions& transient) {
  const Start start = start_of(problem, transient);
  TransientResult result;
  result.start_displacement = start.displacement;
  result.start_velocity = start.velocity;

  const Options on_grid = resolving(problem, options, start);
  const Discretisation on = discretise(problem, on_grid, box_of(problem, options, start));
  const Grid& grid = on.grid;
  result.regularisation_length = on.regularisation_length;
  if (!on.refusal.empty()) {
    result.reason = on.refusal;
    return result;
  }
  result.y_edges = grid.x1.faces();
  result.v_edges = grid.x2.faces();
  const auto posed = posedness(problem, on_grid, on);
  if (!posed.objection.empty()) {
    result.status = Status::ill_posed;
    result.reason = posed.objection;
    return result;
  }
  const auto op = fokker_planck_operator(problem, on_grid, on);
  Preconditioner preconditioner(problem, on.excitation, options.impact, grid);
  step_through(problem, on_grid, transient, grid, op, preconditioner, result);
  return result;
}

}  // namespace

TransientResult integrate(const problem::Problem& problem, const Options& options,
                          const TransientOptions& transient) {
  validate(options, transient);
  if (!problem::of_the_paper(problem)) {
    throw InputError(
        "a density over time beyond the paper's class (one wall at the equilibrium, constant damping "
        "and impulses alone: take the stationary density)");
  }
  const Stopwatch stopwatch;
  TransientResult result = integrate_untimed(problem, options, transient);
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace fpkcheck::fd_fpk
