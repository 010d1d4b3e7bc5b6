#include "fd_fpk/stationary/solve_on_one_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/linear_cvode.hpp"
#include "fd_fpk/operator/impact_rate.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/status_checks.hpp"

namespace fpkcheck::fd_fpk {

PseudoTransientResult integrate_to_stationarity(const FokkerPlanckOperator& op,
                                                Preconditioner& preconditioner,
                                                const Eigen::VectorXd& initial_averages,
                                                double tolerance, double decay_time,
                                                const base::Deadline& deadline) {
  constexpr long kMaxSteps = 200;
  // Time step of the integration to stationarity, in decay times. Longer time steps are not used
  // because rounding errors in (I - gamma L)^-1 displace mass by about 1e-15 gamma ||L||.
  constexpr double kStep = 500;
  // With tolerances above the density, local errors do not limit the time steps of CVODE.
  constexpr double kRelativeTolerance = 1, kPeakMultiple = 1000;
  const double absolute_tolerance = kPeakMultiple * initial_averages.maxCoeff();
  // The tolerances of the time steps refer to the masses of cells instead of densities. Tolerances
  // of densities would shorten the time steps, because the density varies strongly in the narrow
  // cells at a singularity. Under white noise, with the restitution coefficient 0.6, GMRES requires
  // 860 iterations with tolerances of densities and 372 with tolerances of masses.
  const Eigen::VectorXd absolute_tolerances =
      absolute_tolerance * op.areas.mean() / op.areas.array();
  // In a time step with the coefficient gamma, the GMRES residual relative to the peak density is
  // gamma times the contribution of the GMRES residual to L P. The tolerance of GMRES is a tenth of
  // the larger of two residuals: the stationarity residual expected after the time step, about
  // 1/gamma of the preceding residual with gamma in decay times, and the requested stationarity
  // residual. If the requested stationarity residual is very small, kLeast keeps the tolerance of
  // GMRES above the rounding errors.
  constexpr double kPart = 0.1, kLeast = 1e-11;
  const auto linear_tolerance = [&](double residual) {
    const double part = kPart * decay_time * std::max(residual, kStep * tolerance);
    return std::clamp(part, kLeast, kPart) / kPeakMultiple;
  };
  const base::Stopwatch stopwatch;
  const double factored_before = preconditioner.factor_seconds();
  PseudoTransientResult pseudo_transient;
  pseudo_transient.residual = op.stationarity_residual(initial_averages);
  LinearOdeSystem system = make_linear_ode_system(
      [&op](double, const Eigen::VectorXd& p) { return op * p; }, preconditioner);
  LinearCvodeIntegrator cvode(with_deadline_check(deadline, std::move(system)), initial_averages,
                              {.max_order = 1,
                               .relative_tolerance = kRelativeTolerance,
                               .absolute_tolerance = absolute_tolerance,
                               .linear_tolerance = linear_tolerance(pseudo_transient.residual),
                               .absolute_tolerances = absolute_tolerances,
                               .first_step = kStep * decay_time,
                               .max_step = kStep * decay_time});
  while (pseudo_transient.residual > tolerance && pseudo_transient.steps < kMaxSteps) {
    const base::Stopwatch of_step;
    cvode.set_linear_tolerance(linear_tolerance(pseudo_transient.residual));
    int flag = 0;
    try {
      flag = cvode.take_step().flag;
    } catch (const DeadlineExceeded&) {
      pseudo_transient.out_of_time = true;
      break;
    }
    pseudo_transient.steps = cvode.step_count();
    if (flag < 0) {
      pseudo_transient.reason = fmt::format("CVODE failed at step {} (flag {}): {}",
                                            pseudo_transient.steps, flag, cvode.error_message());
      break;
    }
    pseudo_transient.residual = op.stationarity_residual(cvode.cell_averages());
    if (pseudo_transient.residual > tolerance && !deadline.has_time_for(of_step.seconds())) {
      pseudo_transient.out_of_time = true;
      break;
    }
  }
  pseudo_transient.rhs_evaluations = cvode.rhs_evaluation_count();
  pseudo_transient.krylov_iterations = cvode.krylov_iteration_count();
  pseudo_transient.krylov_seconds =
      stopwatch.seconds() - (preconditioner.factor_seconds() - factored_before);
  // The density is normalised to mass 1 again, because the residual of GMRES changes the mass.
  pseudo_transient.averages = cvode.cell_averages() / op.total_mass(cvode.cell_averages());
  return pseudo_transient;
}

namespace {

using transform::Status;

// Returns the stationary density by the method of FiniteVolumeOptions::stepper, and sets the status
// of the result; empty without a density.
std::optional<Eigen::VectorXd> stationary_density(DirectStationarySolution& direct,
                                                  const FiniteVolumeOptions& options,
                                                  const base::Deadline& deadline,
                                                  FiniteVolumeResult& result) {
  auto& [solution, summary] = result;
  if (!direct.averages) {
    solution.status = Status::failed;
    solution.reason = direct.failure;
    return std::nullopt;
  }
  const double frequency = direct.scales.frequency;
  // CVODE starts if this multiple of the time of the direct solution remains before the deadline
  constexpr double kStepsInFull = 20;
  std::optional<PseudoTransientResult> pseudo_transient;
  if (options.stepper == StationarySolver::cvode && direct.converged &&
      deadline.has_time_for(kStepsInFull * direct.krylov_seconds)) {
    pseudo_transient = integrate_to_stationarity(
        direct.op, *direct.preconditioner,
        initial_gaussian(direct.discretisation.grid, direct.scales),
        options.residual_tolerance * frequency, 1 / direct.scales.slowest_decay_rate, deadline);
  }
  std::optional<Eigen::VectorXd> averages;
  if (!pseudo_transient || pseudo_transient->out_of_time) {
    summary.krylov_iterations = direct.krylov_iterations;
    summary.krylov_seconds = direct.krylov_seconds;
    summary.residual = direct.op.stationarity_residual(*direct.averages) / frequency;
    averages = direct.averages;
  } else {
    summary.steps = pseudo_transient->steps;
    summary.rhs_evaluations = pseudo_transient->rhs_evaluations;
    summary.krylov_iterations = pseudo_transient->krylov_iterations;
    summary.krylov_seconds = pseudo_transient->krylov_seconds;
    summary.residual = pseudo_transient->residual / frequency;
    summary.stepped_against_direct =
        (pseudo_transient->averages - *direct.averages).cwiseAbs().maxCoeff() /
        direct.averages->maxCoeff();
    solution.reason = pseudo_transient->reason;
    if (pseudo_transient->averages.allFinite()) averages = std::move(pseudo_transient->averages);
  }
  summary.factorisations = direct.preconditioner->factorisation_count();
  summary.factor_seconds = direct.preconditioner->factor_seconds();
  solution.status = Status::ok;
  if (!(summary.residual <= options.residual_tolerance)) {
    solution.status = Status::not_converged;
    if (solution.reason.empty()) {
      solution.reason = fmt::format(
          "residual {:.1e} after {} steps and {} factorisations, requested {:.1e}",
          summary.residual, summary.steps, summary.factorisations, options.residual_tolerance);
    }
  }
  return averages;
}

void set_results(const problem::Problem& problem, const problem::MotionScales& scales,
                 const FiniteVolumeOptions& options, const DirectStationarySolution& direct,
                 const Eigen::VectorXd& averages, FiniteVolumeResult& result) {
  auto& [solution, summary] = result;
  const auto& [grid, excitation, length, failure, cells] = direct.discretisation;
  const int order = transport_order(options);
  solution.density = grid_density_from_averages(grid, averages);
  solution.moments = physical_moments(problem.frame, grid, averages, order);
  solution.mass = grid.cell_areas().dot(averages);
  solution.min_density = averages.minCoeff() / averages.maxCoeff();
  summary.wall = relative_box_edge_density(scales, grid, averages);
  summary.impact_rate = impact_rate(problem.system, excitation, options.impact, grid, averages,
                                    direct.op * averages, order);
  solution.energy_residual = power_balance_residual(problem, options.impact, grid, averages, order);
  summary.balances =
      balance_residuals(problem, grid, averages, order,
                        wall_momentum_transfer(problem.system, grid, averages, order));
}

// Returns the computational box enlarged by half in each direction in which the density at the end
// is significant; empty if the densities at all ends are negligible. Under rare impulses, for
// example, the density at a distance of 8 standard deviations is 1e-6 of the peak, and the mass
// beyond this distance contributes 4e-4 of E[y^4].
std::optional<EnlargedBox> make_enlarged_box(const problem::Problem& problem,
                                             const FiniteVolumeOptions& options,
                                             const PhasePlaneGrid& grid,
                                             const BoxEdgeDensity& wall) {
  constexpr double kMinLevelRatio = 1.5, kNegligible = 1e-9;
  const double in_x1 = wall.x1 > kNegligible ? kMinLevelRatio : 1;
  const double in_x2 = wall.x2 > kNegligible ? kMinLevelRatio : 1;
  if (in_x1 == 1 && in_x2 == 1) return std::nullopt;
  return enlarge_box(problem, options, grid, in_x1, in_x2);
}

void set_grid_data(const PlaneDiscretisation& discretisation, FiniteVolumeSummary& summary) {
  const PhasePlaneGrid& grid = discretisation.grid;
  summary.nx = grid.nx();
  summary.nv = grid.v_cell_count();
  summary.x1_max = grid.x1_max();
  summary.x2_max = grid.x2_max();
  summary.regularisation_length = discretisation.regularisation_length;
}

}  // namespace

FiniteVolumeResult solve_on_one_grid(const problem::Problem& problem,
                                     const MotionScalesAndComputationalBox& scales_and_box,
                                     const FiniteVolumeOptions& options,
                                     const base::Deadline& deadline) {
  FiniteVolumeResult result;
  auto& [solution, summary] = result;
  // The stability check requires only the velocity step and therefore precedes the solution.
  const auto first = discretise_density_equation(
      problem, options, initial_box(problem, scales_and_box.scales, options));
  set_grid_data(first, summary);
  if (!first.failure.empty()) {
    solution.status = Status::failed;
    solution.reason = first.failure;
    return result;
  }
  const auto [growth, ill_posed] = check_well_posedness(problem, options, first);
  summary.growth_rate = growth.rate;
  summary.growth_wavenumber = growth.wavenumber;
  if (!ill_posed.empty()) {
    solution.status = Status::ill_posed;
    solution.reason = ill_posed;
    return result;
  }

  DirectStationarySolution direct =
      compute_direct_solution(problem, scales_and_box, options, deadline);
  set_grid_data(direct.discretisation, summary);
  summary.order = transport_order(options);
  summary.balances_limit_errors = !problem.system.has_polynomial_force();
  summary.refinement = direct.refinement;
  summary.origin_refinement = direct.origin_refinement;
  if (direct.averages) {
    summary.nonzeros = direct.op.local.nonZeros();
    summary.leak = direct.op.max_mass_loss_rate();
    summary.factor_entries = direct.preconditioner->factor_entry_count();
  }
  const auto density = stationary_density(direct, options, deadline, result);
  if (density) {
    const PhasePlaneGrid& grid = direct.discretisation.grid;
    set_results(problem, scales_and_box.scales, options, direct, *density, result);
    if (has_linearised_scales(problem)) {
      summary.enlarged_box = make_enlarged_box(problem, options, grid, summary.wall);
    } else {
      summary.moments_outside_box = moments_outside_box(problem, grid, *density, solution.moments);
    }
    check_box_size(problem.frame, grid, result);
    check_resolution(options, result);
    if (must_satisfy_balances(problem)) check_balances(result);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
