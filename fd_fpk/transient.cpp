#include "fd_fpk/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fd_fpk/direct_solution.hpp"
#include "fd_fpk/discretisation.hpp"
#include "fd_fpk/linear_cvode.hpp"
#include "fd_fpk/observables.hpp"
#include "fd_fpk/well_posedness.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// As in solve(): what a density that its box holds and its grid resolves does not do.
constexpr double kMostOnWall = 1e-3;
constexpr double kMostNegative = -1e-3;
constexpr double kPowerAllowed = 1e-2;
// Deviations of the start that the box holds, and cells to one of them at least.
constexpr double kStartBox = 6;
constexpr double kStartCells = 5;

double potential_energy(const problem::System& system, double y) {
  return y * y * (system.stiffness() / 2 + system.cubic() * y * y / 4);
}

// The y > 0 at which all of the energy is potential.
double turning_point(const problem::System& system, double energy) {
  const double k = system.stiffness(), mu = system.cubic();
  // mu y^4 / 4 + k y^2 / 2 = energy, without cancellation for small mu.
  return std::sqrt(4 * energy / (k + std::sqrt(k * k + 4 * mu * energy)));
}

// Energy, and its rate for the rate of a density: linear in `averages`.
double energy(const problem::System& system, const transform::Moments& of) {
  return of.v2 / 2 + system.stiffness() * of.y2 / 2 + system.cubic() * of.y4 / 4;
}

/// The deviations of the start, after the options.
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
  Box box = stationary_box(problem, options);
  const double y = kStartBox * start.displacement, v = kStartBox * start.velocity;
  if (!options.x1_max) box.x1_max = std::max({box.x1_max, y, turning_point(system, v * v / 2)});
  if (!options.x2_max)
    box.x2_max = std::max({box.x2_max, v, std::sqrt(2 * potential_energy(system, y))});
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
  s.energy = energy(problem.system, s.moments);
  const double energy_rate = energy(problem.system, moments(grid, op * averages, options.order));
  const auto [input, dissipated] =
      problem::power(problem, options.impact,
                     {.mean_velocity = s.moments.v1,
                      .mean_square_velocity = s.moments.v2,
                      .impact_energy_flux = impact_flux(grid, averages, options.order, 3)});
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
  if (const double wall = std::max(at.wall.x1, at.wall.x2); !(wall <= kMostOnWall)) {
    result.status = Status::failed;
    result.reason = fmt::format(
        "the box y <= {:.3g}, |y'| <= {:.3g} is too small: at t = {:.4g} the density on its wall "
        "is {:.1e} of the peak (widen it with y-max and v-max)",
        grid.x1_max(), grid.x2_max(), at.time, wall);
  } else if (at.min_density < kMostNegative) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "at t = {:.4g} the density is negative down to {:.1g} of its peak: grid or time steps do not "
        "resolve it (refine, start wider, take order 3 or a smaller time tolerance)",
        at.time, at.min_density);
  } else if (std::abs(at.power_residual) > kPowerAllowed) {
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
  using sundials_owned::check;
  constexpr long kMostSteps = 1000000;  // between two snapshots
  // Of the local error; the rest of it goes into mass that is lost.
  constexpr double kLinearTolerance = 1e-3;
  constexpr int kStepsPerFactorisation = 10000;  // L is constant: a new gamma is what asks for one

  const Eigen::VectorXd start =
      folded_gaussian(grid, result.start_displacement, result.start_velocity);
  LinearCvode cvode(op, preconditioner, start,
                    {.max_order = transient.max_order,
                     .relative_tolerance = transient.relative_tolerance,
                     .absolute_tolerance = transient.relative_tolerance * start.maxCoeff(),
                     .linear_tolerance = kLinearTolerance});
  check(CVodeSetMaxNumSteps(cvode.get(), kMostSteps), "CVodeSetMaxNumSteps");
  check(CVodeSetStopTime(cvode.get(), transient.until), "CVodeSetStopTime");
  check(CVodeSetLSetupFrequency(cvode.get(), kStepsPerFactorisation), "CVodeSetLSetupFrequency");

  result.status = Status::ok;
  for (int n = 0; n <= transient.snapshots && result.status == Status::ok; ++n) {
    const double time =
        n == transient.snapshots ? transient.until : n * (transient.until / transient.snapshots);
    double reached = 0;
    if (const int flag = n == 0 ? 0 : cvode.advance(time, CV_NORMAL, reached); flag < 0) {
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
  const auto [grid, excitation, regularisation_length, refusal] =
      discretise(problem, on_grid, box_of(problem, options, start));
  result.regularisation_length = regularisation_length;
  if (!refusal.empty()) {
    result.reason = refusal;
    return result;
  }
  result.y_edges = grid.x1.faces();
  result.v_edges = grid.x2.faces();
  const auto posed = posedness(problem, on_grid, {grid, excitation, regularisation_length});
  if (!posed.objection.empty()) {
    result.status = Status::ill_posed;
    result.reason = posed.objection;
    return result;
  }
  const auto op =
      fokker_planck_operator(problem.system, excitation, options.impact, grid, options.order);
  Preconditioner preconditioner(problem, excitation, options.impact, grid);
  step_through(problem, on_grid, transient, grid, op, preconditioner, result);
  return result;
}

void require_positive(double value, const char* what) {
  if (!(std::isfinite(value) && value > 0)) {
    throw InputError(fmt::format("{} = {} (must be a positive number)", what, value));
  }
}

// Upwind-biased operators of order 3 and 5 have no eigenvalue to the right of the imaginary axis.
// Centred ones, and the one-sided stencils of order 7 at the walls, do: a march to stationarity
// with long implicit steps does not see them, accurate steps in time follow them.
void require_stable_order(int order) {
  if (order != 3 && order != 5) {
    throw InputError(fmt::format(
        "finite-difference order {} over time (it has growing modes: use 3 or 5)", order));
  }
}

}  // namespace

void validate(const Options& options, const TransientOptions& transient) {
  constexpr int kMostSnapshots = 10000;
  constexpr int kHighestOrder = 5;
  validate(options);
  require_stable_order(options.order);
  if (options.tolerance || options.error_estimate) {
    throw InputError(
        "tolerance or error over time (they are for the stationary density: leave "
        "them out)");
  }
  require_positive(transient.until, "until");
  if (transient.snapshots < 1 || transient.snapshots > kMostSnapshots) {
    throw InputError(fmt::format("snapshots = {} (must be between 1 and {})", transient.snapshots,
                                 kMostSnapshots));
  }
  if (transient.start_displacement) require_positive(*transient.start_displacement, "start-y");
  if (transient.start_velocity) require_positive(*transient.start_velocity, "start-v");
  if (!(transient.relative_tolerance > 0 && transient.relative_tolerance < 1)) {
    throw InputError(fmt::format("time tolerance {} (must be between 0 and 1, e.g. 1e-5)",
                                 transient.relative_tolerance));
  }
  if (transient.max_order < 1 || transient.max_order > kHighestOrder) {
    throw InputError(
        fmt::format("order {} of BDF (must be 1 .. {})", transient.max_order, kHighestOrder));
  }
}

TransientResult integrate(const problem::Problem& problem, const Options& options,
                          const TransientOptions& transient) {
  validate(options, transient);
  const auto begin = std::chrono::steady_clock::now();
  TransientResult result = integrate_untimed(problem, options, transient);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  result.seconds = elapsed.count();
  return result;
}

}  // namespace fpkcheck::fd_fpk
