#include "fd_fpk/functionals/energy_passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/functionals/density_interpolation.hpp"
#include "fd_fpk/functionals/energy_level_grid.hpp"
#include "fd_fpk/functionals/passage_values.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Data of a first passage above an energy level, in wall coordinates.
struct EnergyPassageProblem {
  const problem::Problem& problem;
  const FiniteVolumeOptions& options;
  MotionScalesAndComputationalBox scales_and_box;
  problem::EffectivePotential potential;  // of the spring
  double level;
  problem::HalfCycle interval;  // interval of y in which the potential is below the level
  BackwardEquationExcitation excitation;
  std::optional<transform::PassageStartState> start;
  double waiting_rate;  // as PassageInitialConditions::waiting_rate
};

// Returns why finite differences below an energy level do not treat a problem; empty if they do.
std::string energy_passage_unsupported_reason(const problem::Problem& problem,
                                              const FiniteVolumeOptions& options) {
  if (std::string reason = transient_unsupported_reason(problem, options); !reason.empty()) {
    return reason;
  }
  if (options.equation != DensityEquation::kf && options.equation != DensityEquation::white) {
    return "an energy barrier needs the equation kf or white";
  }
  if (options.impact != problem::ImpactCondition::map) {
    return "an energy barrier needs the exact impact condition; use a method without -delta";
  }
  if (problem.noise_factor || problem.impulse_factor) {
    return "an energy barrier does not support noise.factor and impulse.factor; use "
           "--displacement";
  }
  return "";
}

// Returns the grid below the level. The number of nodes in eta resolves the change of v by one
// impulse, or by the noise in one period, since the mean passage time changes over this distance
// from the level.
EnergyLevelGrid make_energy_level_grid(const EnergyPassageProblem& passage, double refinement) {
  constexpr double kFewest = 40, kMost = 120, kNodesPerDeviation = 3;
  const double frequency = passage.scales_and_box.scales.frequency;
  double deviation = std::sqrt(2 * passage.excitation.diffusion * 2 * std::numbers::pi / frequency);
  if (passage.excitation.impulse_rate > 0) {
    deviation = std::hypot(deviation, passage.excitation.law->amplitude_standard_deviation());
  }
  double lowest =
      std::min(passage.potential(passage.interval.left), passage.potential(passage.interval.right));
  for (const double y : passage.potential.extremum_positions()) {
    if (y > passage.interval.left && y < passage.interval.right) {
      lowest = std::min(lowest, passage.potential(y));
    }
  }
  const double speed = std::sqrt(2 * (passage.level - lowest));
  const double nodes =
      refinement * std::clamp(kNodesPerDeviation * 2 * speed / deviation, kFewest, kMost);
  return {passage.problem.system,
          passage.potential,
          passage.interval,
          passage.level,
          static_cast<int>(std::ceil(nodes * 0.8)),
          2 * static_cast<int>(std::ceil(nodes / 2)),
          passage.excitation};
}

// Returns the mean times from the starts in equal cells of a rectangle, 0 above the level. The map
// is empty for a mirrored wall frame.
std::optional<transform::MeanPassageTimeMap> energy_mean_time_map(
    const EnergyPassageProblem& passage, const EnergyLevelGrid& grid,
    const Eigen::VectorXd& mean_passage_times_by_start) {
  const problem::WallFrame& frame = passage.problem.frame;
  if (frame.mirrored) return std::nullopt;
  constexpr int kColumns = 120, kRows = 80;
  double fastest = 0;
  for (int i = 0; i < grid.displacement_count(); ++i) {
    fastest = std::max(fastest, grid.speed_on_level(grid.displacement(i)));
  }
  const auto& [left, right, left_is_wall, right_is_wall] = passage.interval;
  transform::MeanPassageTimeMap map;
  for (int i = 0; i <= kColumns; ++i) {
    map.y_edges.push_back(frame.physical_y(std::lerp(left, right, 1.0 * i / kColumns)));
  }
  for (int j = 0; j <= kRows; ++j) map.v_edges.push_back(fastest * (2.0 * j / kRows - 1));
  for (int i = 0; i < kColumns; ++i) {
    const double y = std::lerp(left, right, (i + 0.5) / kColumns);
    for (int j = 0; j < kRows; ++j) {
      const double v = (map.v_edges[j] + map.v_edges[j + 1]) / 2;
      const bool is_below = std::abs(v) < grid.speed_on_level(y);
      map.averages.push_back(
          is_below ? grid.interpolation_weights_at_state(y, v).dot(mean_passage_times_by_start)
                   : 0);
    }
  }
  return map;
}

PassageResultOnGrid energy_passage_on_grid(const EnergyPassageProblem& passage, double refinement,
                                           const std::vector<double>& times,
                                           const base::Deadline& deadline) {
  PassageResultOnGrid result;
  FunctionalValuesOnGrid& level = result.values_on_grid;
  const EnergyLevelGrid grid = make_energy_level_grid(passage, refinement);
  level.nx = grid.displacement_count();
  level.nv = grid.velocity_count();
  // The matrix itself contains dense blocks of the impulses and may need much memory.
  level.failure = ShiftedLinearSystem::large_factors_reason(grid.size(), level.nv, kDefaultOrder);
  if (!level.failure.empty()) return result;
  const DirectStationarySolution stationary =
      compute_direct_solution(passage.problem, passage.scales_and_box,
                              with_refined_cells(passage.options, refinement), deadline);
  if (!stationary.averages || !stationary.converged) {
    level.failure = stationary.averages
                        ? "GMRES did not find the stationary density; use another grid"
                        : stationary.failure;
    return result;
  }
  const DensityInterpolation density(stationary.discretisation.grid, *stationary.averages);
  PassageInitialConditions starts{.from_stationary = grid.integration_weights()};
  for (int i = 0; i < level.nx; ++i) {
    for (int j = 0; j < level.nv; ++j) {
      starts.from_stationary(grid.grid_node_index(i, j)) *=
          density(grid.displacement(i), grid.velocity(i, j));
    }
  }
  const double probability = starts.from_stationary.sum();
  starts.from_stationary /= probability;
  if (const auto& start = passage.start) {
    starts.waiting_rate = passage.waiting_rate;
    starts.from_point = passage.waiting_rate > 0
                            ? grid.mean_after_impulse_weights(start->y)
                            : grid.interpolation_weights_at_state(start->y, start->ydot);
  }
  const FokkerPlanckOperator op{
      .local = grid.backward_matrix(), .exchange = {}, .areas = Eigen::VectorXd::Ones(grid.size())};
  const ShiftedLinearSystem system(op, nullptr, level.nv, kDefaultOrder,
                                   survival_resolvent_shift(passage.scales_and_box.scales));
  ReducedResolvent model(system, op.areas);
  Eigen::VectorXd values = compute_passage_values(model, starts, times, passage.options.accuracy,
                                                  deadline, level.failure);
  if (values.size() == 0) return result;
  values(kProbabilityBelow) = probability;
  level.values = values;
  result.mean_passage_times_by_start =
      energy_mean_time_map(passage, grid, model.shifted_solution(0));
  return result;
}

}  // namespace

transform::FirstPassageResult solve_energy_passage(
    const problem::Problem& problem, const FiniteVolumeOptions& options, double energy,
    std::vector<double> times, std::optional<transform::PassageStartState> start) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::FirstPassageResult passage{.id = solution_id(options), .status = Status::not_offered};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  passage.reason = energy_passage_unsupported_reason(transformed, options);
  if (!passage.reason.empty()) return passage;
  const double level = transform::energy_level_in_wall_coordinates(transformed, energy);
  const problem::UndampedOrbits orbits({.name = "", .system = transformed.system});
  if (!orbits.is_confining()) {
    passage.reason = "the potential of the force does not confine the motion; use mcs";
    return passage;
  }
  const std::vector<problem::HalfCycle> intervals = orbits.half_cycles(level);
  if (intervals.size() != 1) {
    passage.reason =
        intervals.empty()
            ? "the energy of every state is above the barrier; choose a higher barrier"
            : "the barrier is below a maximum of the potential, so that the states below the "
              "barrier are disconnected; choose a higher barrier, or use mcs";
    return passage;
  }
  const base::Deadline deadline(options.max_seconds);
  FiniteVolumeOptions with_order = options;
  with_order.order = options.order.value_or(automatic_scheme_order(transformed));
  if (!has_linearised_scales(transformed))
    with_order.wall_density *= box_edge_density_factor(transformed);
  MotionScalesAndComputationalBox scales_and_box{.scales = problem::motion_scales(transformed)};
  scales_and_box.box = stationary_box(transformed, scales_and_box.scales, with_order, deadline);
  const auto rest =
      problem::rest_displacement(transformed, std::numeric_limits<double>::infinity());
  start =
      transform::passage_start_state(transformed, std::numeric_limits<double>::infinity(), start);
  const problem::EffectivePotential potential(transformed.system);
  if (start && start->ydot * start->ydot / 2 + potential(start->y) >= level) start.reset();
  const bool is_at_rest = start && rest && start->y == *rest && start->ydot == 0;
  const BackwardEquationExcitation excitation =
      BackwardEquationExcitation::of_equation(transformed, options.equation);
  const bool waits = excitation.diffusion == 0 && is_at_rest;
  const EnergyPassageProblem below{.problem = transformed,
                                   .options = with_order,
                                   .scales_and_box = std::move(scales_and_box),
                                   .potential = potential,
                                   .level = level,
                                   .interval = intervals.front(),
                                   .excitation = excitation,
                                   .start = start,
                                   .waiting_rate = waits ? excitation.impulse_rate : 0};
  passage.status = Status::failed;
  solve_passage_on_grids(
      [&](double refinement, const std::vector<double>& at) {
        return energy_passage_on_grid(below, refinement, at, deadline);
      },
      options, kPassageOrder, std::move(times), start.has_value(), "nodes", deadline, passage);
  passage.seconds = stopwatch.seconds();
  return passage;
}

}  // namespace fpkcheck::fd_fpk
