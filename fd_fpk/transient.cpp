#include "fd_fpk/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "base/input_error.hpp"
#include "base/process/stopwatch.hpp"
#include "fd_fpk/applicability.hpp"
#include "fd_fpk/linear/linear_cvode.hpp"
#include "fd_fpk/operator/impact_rate.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/time_dependent_operator.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/status_checks.hpp"
#include "numerics/roots/fixed_point.hpp"
#include "problem/initial_density.hpp"
#include "problem/motion_scales.hpp"
#include "problem/time_dependence.hpp"
#include "problem/undamped_orbits.hpp"
#include "transform/conservative_remap.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

constexpr double kCellsPerDeviation = 5;

// Returns a computational box with the initial density, the stationary density and all states that
// the initial energy can reach, extended by the motion under the force F(t).
PhasePlaneBox transient_box(const problem::Problem& problem, const problem::MotionScales& scales,
                            const FiniteVolumeOptions& options,
                            const problem::InitialGaussian& start, const problem::TimeSpan& span,
                            const base::Deadline& deadline) {
  const auto& system = problem.system;
  PhasePlaneBox box = stationary_box(problem, scales, options, deadline);
  const problem::StateRange reached = problem::reachable_state_range(problem, start);
  const problem::MotionExtent forced = problem::forced_motion_extent(problem, span);
  if (!options.x1_max) {
    if (!system.left_wall()) box.x1_min = std::min(box.x1_min, reached.y_low) - forced.displacement;
    if (!system.right_wall())
      box.x1_max = std::max(box.x1_max, reached.y_high) + forced.displacement;
  }
  if (!options.x2_max) box.x2_max = std::max(box.x2_max, reached.v_high) + forced.speed;
  return box;
}

// Returns the options with cells refined for the initial density. A narrow initial density requires
// narrow cells in both y and y', since the flow rotates the density in the phase plane.
FiniteVolumeOptions refine_for_initial_density(FiniteVolumeOptions options,
                                               const DensityLengthScales& of_stationary,
                                               const problem::InitialGaussian& start) {
  constexpr double kCells = 6;  // number of cells of the automatic grid per length scale
  const double narrowness = std::max(of_stationary.x1 / start.displacement_deviation,
                                     of_stationary.x2 / start.velocity_deviation);
  options.refinement *= std::max(1.0, narrowness * kCellsPerDeviation / kCells);
  // Narrow cells at the origin would make the time-dependent equations stiff and hardly improve the
  // accuracy.
  options.origin_refinement = options.origin_refinement.value_or(1);
  return options;
}

DensitySnapshot make_snapshot(const problem::Problem& problem,
                              const problem::EffectivePotential& spring_potential,
                              const FiniteVolumeOptions& options,
                              const PlaneDiscretisation& discretisation,
                              const TimeDependentOperator& op, const Eigen::VectorXd& averages,
                              double time) {
  const PhasePlaneGrid& grid = discretisation.grid;
  const Eigen::VectorXd change = op.apply_at_time(time, averages);
  const problem::System& system = problem.system;
  const problem::WallFrame& frame = problem.frame;
  DensitySnapshot s{.time = time,
                    .moments = physical_moments(frame, grid, averages, transport_order(options)),
                    .yv = physical_mixed_moment(frame, grid, averages, transport_order(options))};
  // The potential U(y) of the spring is 0 at y = 0, for every origin of the wall coordinates.
  s.energy = mean_energy(spring_potential, grid, averages, transport_order(options)) -
             spring_potential(frame.wall_coordinate(0));
  const double energy_rate = mean_energy(spring_potential, grid, change, transport_order(options));
  const auto [input, dissipated] =
      problem::power_balance(problem::with_excitation_at_time(problem, time),
                             power_balance_terms(problem, options.impact,
                                                 moments(grid, averages, transport_order(options)),
                                                 grid, averages, transport_order(options)));
  const double power_of_force =
      problem.time.external_force(time) * frame.physical_velocity(s.moments.v1);
  s.power = input - dissipated + power_of_force;
  const double input_scale =
      problem::total_excitation_intensity(problem) / 2 + std::abs(power_of_force);
  s.power_residual = (s.power - energy_rate) / input_scale;
  // The initial Gaussian is bounded at the walls, so that the impact rate is the flux into the
  // walls.
  s.impact_rate =
      time == 0 ? flux_into_walls(system, grid, averages, transport_order(options))
                : impact_rate(system, excitation_at_time(problem, options, discretisation, time),
                              options.impact, grid, averages, change, transport_order(options));
  s.mass = op.total_mass(averages);
  s.min_density = averages.minCoeff() / averages.maxCoeff();
  s.wall = relative_box_edge_density(problem::motion_scales(problem), grid, averages);
  const auto [y, ydot] = marginals(grid, averages);
  s.y.assign(y.begin(), y.end());
  s.v.assign(ydot.begin(), ydot.end());
  if (frame.mirrored) {
    std::ranges::reverse(s.y);
    std::ranges::reverse(s.v);
  }
  return s;
}

void check_snapshot(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                    const DensitySnapshot& snapshot, TransientResult& result) {
  const std::string when = fmt::format("at t = {:.4g} ", snapshot.time);
  if (std::string small = small_box_failure_reason(frame, grid, snapshot.wall, when);
      !small.empty()) {
    result.status = Status::failed;
    result.reason = std::move(small);
  } else if (!kTransientResolutionLimits.is_density_accepted(snapshot.min_density)) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "the density at t = {:.4g} is negative, {:.1g} of its peak: insufficient resolution; "
        "refine the grid, widen the initial density, use order 3, or reduce time-tolerance",
        snapshot.time, snapshot.min_density);
  } else if (!kTransientResolutionLimits.is_power_residual_accepted(snapshot.power_residual)) {
    result.status = Status::inadmissible;
    result.reason = fmt::format(
        "the power balance at t = {:.4g} has a residual of {:.1g} of the input: insufficient "
        "resolution; refine the grid or widen the initial density",
        snapshot.time, snapshot.power_residual);
  }
}

// Returns a discretisation that resolves the initial and the stationary density, with at most
// `max_cells` cells. A stationary density in narrow potential wells, or concentrated at rest under
// rare impulses, may be narrower than the cells; kTransientResolutionLimits detects the
// insufficient resolution.
PlaneDiscretisation discretise_within_limit(const problem::Problem& problem,
                                            const PhasePlaneBox& box, double max_cells,
                                            FiniteVolumeOptions& options) {
  PlaneDiscretisation discretisation = discretise_density_equation(problem, options, box);
  if (options.nx || options.nv || discretisation.cells <= max_cells) return discretisation;
  options.refinement *= std::sqrt(max_cells / discretisation.cells);
  return discretise_density_equation(problem, options, box);
}

// Returns the cell averages of a given density on the cells of another grid.
Eigen::VectorXd remap_to_grid(const CellAveragedDensity& density, const PhasePlaneGrid& grid) {
  const transform::ConservativeRemap along_x1(density.x1_faces, grid.x1.faces()),
      along_x2(density.x2_faces, grid.x2.faces());
  const auto nx = static_cast<Eigen::Index>(density.x1_faces.size()) - 1,
             nv = static_cast<Eigen::Index>(density.x2_faces.size()) - 1;
  const GridAxis x1(density.x1_faces), x2(density.x2_faces);
  const Eigen::MatrixXd masses =
      x2.cell_widths().asDiagonal() *
      Eigen::Map<const Eigen::MatrixXd>(density.averages.data(), nv, nx) *
      x1.cell_widths().asDiagonal();
  Eigen::MatrixXd columns(grid.v_cell_count(), nx), remapped(grid.v_cell_count(), grid.nx());
  const auto remapped_vector = [](const transform::ConservativeRemap& remap,
                                  const Eigen::VectorXd& from) {
    const std::vector<double> to =
        remap(std::span(from.data(), static_cast<std::size_t>(from.size())));
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(to.data(), static_cast<Eigen::Index>(to.size())));
  };
  for (Eigen::Index i = 0; i < nx; ++i) columns.col(i) = remapped_vector(along_x2, masses.col(i));
  for (Eigen::Index j = 0; j < grid.v_cell_count(); ++j) {
    remapped.row(j) = remapped_vector(along_x1, columns.row(j)).transpose();
  }
  return remapped.reshaped().cwiseQuotient(grid.cell_areas());
}

// Integration over time of the cell averages of the density of one problem.
class DensityTimeIntegration {
 public:
  DensityTimeIntegration(const problem::Problem& problem, const FiniteVolumeOptions& options,
                         const TransientOptions& transient,
                         const PlaneDiscretisation& discretisation, const base::Deadline& deadline)
      : problem_(problem),
        options_(options),
        transient_(transient),
        on_(discretisation),
        deadline_(deadline),
        spring_potential_(problem.system),
        op_(problem, options, discretisation),
        preconditioner_(problem, discretisation.excitation, options.impact, discretisation.grid) {}

  // Integrates from the given cell averages to the end time and stores the snapshots.
  void store_snapshots(const Eigen::VectorXd& start, TransientResult& result) {
    integrate_over_snapshots(start, result, [&](double time, const Eigen::VectorXd& averages) {
      add_snapshot(time, averages, result);
      return result.status == Status::ok ||
             (result.status == Status::inadmissible && transient_.continues_if_inadmissible);
    });
  }

  // Finds the periodic state, and stores the periodic state and the snapshots of one period.
  // @param guess cell averages with which the search starts
  void store_periodic_state(const Eigen::VectorXd& guess, TransientResult& result) {
    // Largest accepted L1 distance to the periodic state. The change of the density over a period
    // is only the part of this L1 distance by which the slowest mode decays in a period.
    constexpr double kDistance = 1e-4;
    const double tolerance =
        kDistance * problem::decayed_fraction(problem::motion_scales(problem_), transient_.until);
    std::vector<std::pair<double, Eigen::VectorXd>> last_period;
    const numerics::FixedPointResult found = numerics::solve_fixed_point(
        [&](const Eigen::VectorXd& from) -> std::optional<Eigen::VectorXd> {
          last_period.clear();
          integrate_over_snapshots(from, result, [&](double time, const Eigen::VectorXd& averages) {
            last_period.emplace_back(time, averages);
            return true;
          });
          if (result.status != Status::ok) return std::nullopt;
          const Eigen::VectorXd& end = last_period.back().second;
          return end / op_.total_mass(end);  // GMRES loses some mass
        },
        guess,
        {.size = [&](const Eigen::VectorXd& change) { return op_.total_mass(change.cwiseAbs()); },
         .tolerance = tolerance});
    result.periods = found.evaluations;
    result.change_over_period = found.change;
    result.distance_to_periodic_state = kDistance * found.change / tolerance;
    if (!found.converged) {
      result.reason = fmt::format(
          "no periodic state after {} periods: the density changes by {:.1e} per period (limit "
          "{:.0e}); increase max-seconds, or give several periods as --until{}{}",
          found.evaluations, found.change, tolerance, result.reason.empty() ? "" : "; ",
          result.reason);
      result.status = Status::not_converged;
      return;
    }
    result.periodic_state = {on_.grid.x1.faces(), on_.grid.x2.faces(), found.x};
    for (const auto& [time, averages] : last_period) add_snapshot(time, averages, result);
  }

 private:
  LinearCvodeIntegrator make_integrator(const Eigen::VectorXd& start) {
    constexpr long kMostSteps = 1000000;  // maximum number of steps between two snapshots
    // Tolerance of GMRES as a fraction of the local error; the residual of GMRES causes a loss of
    // mass.
    constexpr double kLinearTolerance = 1e-3;
    // The matrix of the preconditioner is constant, so that a new factorisation is necessary only
    // for a new step coefficient gamma of CVODE.
    constexpr long kStepsPerFactorisation = 10000;
    // Longest time step under an excitation that changes in time, as a fraction of the end time. A
    // longer time step could pass over a short pulse of the excitation, whatever the tolerance of
    // the local error.
    constexpr double kLongestStep = 0.02;
    LinearOdeSystem system = make_linear_ode_system(
        [this](double t, const Eigen::VectorXd& p) { return op_.apply_at_time(t, p); },
        preconditioner_);
    std::optional<double> max_step;
    if (problem_.time.is_acting()) max_step = kLongestStep * transient_.until;
    return {with_deadline_check(deadline_, std::move(system)), start,
            BdfSettings{.max_order = transient_.max_order,
                        .relative_tolerance = transient_.relative_tolerance,
                        .absolute_tolerance = transient_.relative_tolerance * start.maxCoeff(),
                        .linear_tolerance = kLinearTolerance,
                        .max_step = max_step,
                        .stop_time = transient_.until,
                        .max_steps = kMostSteps,
                        .steps_per_factorisation = kStepsPerFactorisation}};
  }

  // Integrates the density over time, and calls on_snapshot(time, averages) at each output time. If
  // the integration does not reach the end time, the function sets the status of the result.
  // @param on_snapshot returns whether the integration continues
  template <class OnSnapshot>
  void integrate_over_snapshots(const Eigen::VectorXd& start, TransientResult& result,
                                const OnSnapshot& on_snapshot) {
    LinearCvodeIntegrator cvode = make_integrator(start);
    const int snapshots = transient_.snapshots;
    for (int n = 0; n <= snapshots; ++n) {
      const double time = n == snapshots ? transient_.until : n * (transient_.until / snapshots);
      LinearCvodeIntegrator::StepResult to{0, 0};
      try {
        if (n > 0) to = cvode.advance_to_time(time);
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
      if (!on_snapshot(time, Eigen::VectorXd(cvode.cell_averages()))) break;
      if (transient_.progress) transient_.progress(static_cast<double>(n) / snapshots);
    }
    add_step_counts(cvode, result);
  }

  void add_snapshot(double time, const Eigen::VectorXd& averages, TransientResult& result) const {
    result.snapshots.push_back(
        make_snapshot(problem_, spring_potential_, options_, on_, op_, averages, time));
    check_snapshot(problem_.frame, on_.grid, result.snapshots.back(), result);
  }

  static void add_step_counts(const LinearCvodeIntegrator& cvode, TransientResult& result) {
    result.steps += cvode.step_count();
    result.factorisations += cvode.factorisation_count();
    result.rhs_evaluations += cvode.rhs_evaluation_count();
    result.krylov_iterations += cvode.krylov_iteration_count();
  }

  const problem::Problem& problem_;
  const FiniteVolumeOptions& options_;
  const TransientOptions& transient_;
  const PlaneDiscretisation& on_;
  const base::Deadline& deadline_;
  problem::EffectivePotential spring_potential_;
  TimeDependentOperator op_;
  Preconditioner preconditioner_;
};

TransientResult solve_without_timing(const problem::Problem& problem,
                                     const FiniteVolumeOptions& options,
                                     const TransientOptions& transient) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const problem::WallFrame& frame = problem.frame;
  const problem::InitialGaussian start =
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
  const PhasePlaneBox box = transient_box(problem, scales, options, start,
                                          {transient.until, transient.periodic}, deadline);
  FiniteVolumeOptions on_grid = refine_for_initial_density(options, box.lengths, start);
  const PlaneDiscretisation discretisation =
      discretise_within_limit(problem, box, transient.max_cells, on_grid);
  const PhasePlaneGrid& grid = discretisation.grid;
  result.regularisation_length = discretisation.regularisation_length;
  if (!discretisation.failure.empty()) {
    result.reason = discretisation.failure;
    return result;
  }
  result.y_edges = transform::y_edges_from_wall_coordinates(frame, grid.x1.faces());
  result.v_edges = transform::transform_v_edges(frame, grid.x2.faces());
  const auto posed = check_well_posedness(problem, on_grid, discretisation);
  if (!posed.ill_posed_reason.empty()) {
    result.status = Status::ill_posed;
    result.reason = posed.ill_posed_reason;
    return result;
  }
  Eigen::VectorXd averages = gaussian_cell_averages(start, grid);
  DensityTimeIntegration integration(problem, on_grid, transient, discretisation, deadline);
  result.status = Status::ok;
  if (transient.periodic) {
    if (transient.periodic_guess) averages = remap_to_grid(*transient.periodic_guess, grid);
    integration.store_periodic_state(averages, result);
  } else {
    integration.store_snapshots(averages, result);
  }
  return result;
}

}  // namespace

TransientResult solve_transient(const problem::Problem& problem, const FiniteVolumeOptions& options,
                                const TransientOptions& transient) {
  validate(options, transient);
  const problem::Problem transformed = problem::to_wall_coordinates(
      problem::wall_frame(problem.system),
      problem::with_largest_excitation(problem, {transient.until, transient.periodic}));
  if (const std::string why = transient_unsupported_reason(transformed, options); !why.empty()) {
    throw InputError(fmt::format("no density over time: {}", why));
  }
  const base::Stopwatch stopwatch;
  TransientResult result = solve_without_timing(transformed, options, transient);
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace fpkcheck::fd_fpk
