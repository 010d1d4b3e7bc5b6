#include "fd_fpk/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/input_error.hpp"
#include "base/process/stopwatch.hpp"
#include "fd_fpk/applicability.hpp"
#include "fd_fpk/linear/linear_cvode.hpp"
#include "fd_fpk/operator/impact_rate.hpp"
#include "fd_fpk/operator/observables.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/status_checks.hpp"
#include "problem/initial_density.hpp"
#include "problem/motion_scales.hpp"
#include "problem/undamped_orbits.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

constexpr double kCellsPerDeviation = 5;

// Returns a box for the initial density, the stationary density and all states that the initial
// energy can reach.
Box transient_box(const problem::Problem& problem, const problem::MotionScales& scales,
                  const Options& options, const problem::Gaussian& start,
                  const base::Deadline& deadline) {
  const auto& system = problem.system;
  Box box = stationary_box(problem, scales, options, deadline);
  const problem::StateRange reached = problem::reachable_states(problem, start);
  if (!options.x1_max) {
    if (!system.left_wall()) box.x1_min = std::min(box.x1_min, reached.y_low);
    if (!system.right_wall()) box.x1_max = std::max(box.x1_max, reached.y_high);
  }
  if (!options.x2_max) box.x2_max = std::max(box.x2_max, reached.v_high);
  return box;
}

// Returns the options with cells refined for the initial density. A narrow initial density requires
// narrow cells in y and in y', since the flow rotates the density in the phase plane.
Options refine_for_initial_density(Options options, const LengthScales& of_stationary,
                                   const problem::Gaussian& start) {
  constexpr double kCells = 6;  // number of cells of the automatic grid per length scale
  const double narrowness = std::max(of_stationary.x1 / start.displacement_deviation,
                                     of_stationary.x2 / start.velocity_deviation);
  options.refinement *= std::max(1.0, narrowness * kCellsPerDeviation / kCells);
  // Narrow cells at the origin would make the equations stiff and hardly improve the accuracy.
  options.origin_refinement = options.origin_refinement.value_or(1);
  return options;
}

DensitySnapshot make_snapshot(const problem::Problem& problem,
                              const problem::EffectivePotential& spring_potential,
                              const Options& options, const Discretisation& on,
                              const FokkerPlanckOperator& op, const Eigen::VectorXd& averages,
                              double time) {
  const Grid& grid = on.grid;
  const Eigen::VectorXd change = op * averages;
  const problem::System& system = problem.system;
  const problem::WallFrame& frame = problem.frame;
  DensitySnapshot s{.time = time,
                    .moments = physical_moments(frame, grid, averages, transport_order(options)),
                    .yv = physical_mixed_moment(frame, grid, averages, transport_order(options))};
  // The potential U is 0 at y = 0, whatever the origin of the wall coordinates.
  s.energy = mean_energy(spring_potential, grid, averages, transport_order(options)) -
             spring_potential(frame.wall_x(0));
  const double energy_rate = mean_energy(spring_potential, grid, change, transport_order(options));
  const auto [input, dissipated] = problem::power_balance(
      problem,
      energy_terms(problem, options.impact, moments(grid, averages, transport_order(options)), grid,
                   averages, transport_order(options)));
  s.power = input - dissipated;
  s.power_residual = (s.power - energy_rate) / (problem::total_intensity(problem) / 2);
  // The initial Gaussian is bounded, so that its impact rate is the flux into the walls.
  s.impact_rate = time == 0 ? flux_into_walls(system, grid, averages, transport_order(options))
                            : impact_rate(system, on.excitation, options.impact, grid, averages,
                                          change, transport_order(options));
  s.mass = op.total_mass(averages);
  s.min_density = averages.minCoeff() / averages.maxCoeff();
  s.wall = relative_box_edge_density(problem::scales(problem), grid, averages);
  const auto [y, ydot] = marginals(grid, averages);
  s.y.assign(y.begin(), y.end());
  s.v.assign(ydot.begin(), ydot.end());
  if (frame.mirrored) {
    std::ranges::reverse(s.y);
    std::ranges::reverse(s.v);
  }
  return s;
}

void check_snapshot(const problem::WallFrame& frame, const Grid& grid, const DensitySnapshot& at,
                    TransientResult& result) {
  const std::string when = fmt::format("at t = {:.4g} ", at.time);
  if (std::string small = box_failure_reason(frame, grid, at.wall, when); !small.empty()) {
    result.status = Status::failed;
    result.reason = std::move(small);
  } else if (!kTransientLimits.is_density_accepted(at.min_density)) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "the density at t = {:.4g} is negative, {:.1g} of its peak: insufficient resolution; "
        "refine the grid, widen the initial density, use order 3, or reduce time-tolerance",
        at.time, at.min_density);
  } else if (!kTransientLimits.is_power_residual_accepted(at.power_residual)) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "the power balance at t = {:.4g} has a residual of {:.1g} of the input: insufficient "
        "resolution; refine the grid or widen the initial density",
        at.time, at.power_residual);
  }
}

// Returns a discretisation that resolves the initial and the stationary density, with at most
// `max_cells` cells. A density in narrow wells, or at rest under rare impulses, is narrower than
// the cells; kTransientLimits detects the insufficient resolution.
Discretisation discretise_within_limit(const problem::Problem& problem, const Box& box,
                                       double max_cells, Options& options) {
  Discretisation on = discretise(problem, options, box);
  if (options.nx || options.nv || on.cells <= max_cells) return on;
  options.refinement *= std::sqrt(max_cells / on.cells);
  return discretise(problem, options, box);
}

void integrate_in_time(const problem::Problem& problem, const Options& options,
                       const TransientOptions& transient, const problem::Gaussian& gaussian,
                       const Discretisation& on, const FokkerPlanckOperator& op,
                       Preconditioner& preconditioner, const base::Deadline& deadline,
                       TransientResult& result) {
  constexpr long kMostSteps = 1000000;  // maximum number of steps between two snapshots
  // Tolerance of GMRES as a fraction of the local error; the residual of GMRES causes a loss of
  // mass.
  constexpr double kLinearTolerance = 1e-3;
  // The operator L is constant, so that CVODE factors again only for a new gamma.
  constexpr long kStepsPerFactorisation = 10000;

  const Grid& grid = on.grid;
  const problem::EffectivePotential spring_potential(problem.system);
  const Eigen::VectorXd start = cell_averages(gaussian, grid);
  LinearCvodeIntegrator cvode(
      with_deadline_check(deadline, linear_ode_system(op, preconditioner)), start,
      {.max_order = transient.max_order,
       .relative_tolerance = transient.relative_tolerance,
       .absolute_tolerance = transient.relative_tolerance * start.maxCoeff(),
       .linear_tolerance = kLinearTolerance,
       .stop_time = transient.until,
       .max_steps = kMostSteps,
       .steps_per_factorisation = kStepsPerFactorisation});

  result.status = Status::ok;
  const auto may_continue = [&] {
    return result.status == Status::ok ||
           (result.status == Status::inadmissible && transient.continues_if_inadmissible);
  };
  for (int n = 0; n <= transient.snapshots && may_continue(); ++n) {
    const double time =
        n == transient.snapshots ? transient.until : n * (transient.until / transient.snapshots);
    LinearCvodeIntegrator::StepResult to{0, 0};
    try {
      if (n > 0) to = cvode.advance(time);
    } catch (const DeadlineExceeded&) {
      result.status = Status::not_converged;
      result.reason = fmt::format(
          "t = {:.4g} not reached: max_seconds expired; increase max-seconds or use fewer cells",
          time);
      break;
    }
    const auto [flag, reached] = to;
    if (flag < 0) {
      result.status = Status::not_converged;
      result.reason = fmt::format("CVODE stopped at t = {:.4g} before t = {:.4g} (flag {}): {}",
                                  reached, time, flag, cvode.error_message());
      break;
    }
    result.snapshots.push_back(
        make_snapshot(problem, spring_potential, options, on, op, cvode.averages(), time));
    check_snapshot(problem.frame, grid, result.snapshots.back(), result);
    if (transient.progress) transient.progress(static_cast<double>(n) / transient.snapshots);
  }
  result.steps = cvode.step_count();
  result.factorisations = cvode.factorisation_count();
  result.rhs_evaluations = cvode.rhs_evaluation_count();
  result.krylov_iterations = cvode.krylov_iteration_count();
}

TransientResult solve_without_timing(const problem::Problem& problem, const Options& options,
                                     const TransientOptions& transient) {
  const problem::MotionScales scales = problem::scales(problem);
  const problem::WallFrame& frame = problem.frame;
  const problem::Gaussian start =
      problem::initial_density(problem, scales,
                               {.displacement_deviation = transient.start_displacement,
                                .velocity_deviation = transient.start_velocity,
                                .mean_displacement = transient.start_mean_displacement,
                                .mean_velocity = transient.start_mean_velocity});
  TransientResult result;
  result.start_displacement = start.displacement_deviation;
  result.start_velocity = start.velocity_deviation;
  result.start_mean_displacement = frame.physical_y(start.mean_displacement);
  result.start_mean_velocity = frame.physical_velocity(start.mean_velocity);

  const base::Deadline deadline(options.max_seconds);
  const Box box = transient_box(problem, scales, options, start, deadline);
  Options on_grid = refine_for_initial_density(options, box.lengths, start);
  const Discretisation on = discretise_within_limit(problem, box, transient.max_cells, on_grid);
  const Grid& grid = on.grid;
  result.regularisation_length = on.regularisation_length;
  if (!on.failure.empty()) {
    result.reason = on.failure;
    return result;
  }
  result.y_edges = transform::to_y_edges(frame, grid.x1.faces());
  result.v_edges = transform::transform_v_edges(frame, grid.x2.faces());
  const auto posed = check_well_posedness(problem, on_grid, on);
  if (!posed.ill_posed_reason.empty()) {
    result.status = Status::ill_posed;
    result.reason = posed.ill_posed_reason;
    return result;
  }
  const auto op = fokker_planck_operator(problem, on_grid, on);
  Preconditioner preconditioner(problem, on.excitation, options.impact, grid);
  integrate_in_time(problem, on_grid, transient, start, on, op, preconditioner, deadline, result);
  return result;
}

}  // namespace

TransientResult solve_transient(const problem::Problem& problem, const Options& options,
                                const TransientOptions& transient) {
  validate(options, transient);
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  if (const std::string why = transient_unsupported_reason(transformed, options); !why.empty()) {
    throw InputError(fmt::format("no density over time: {}", why));
  }
  const base::Stopwatch stopwatch;
  TransientResult result = solve_without_timing(transformed, options, transient);
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace fpkcheck::fd_fpk
