#include "fd_fpk/functionals/passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/functionals/barrier_passage.hpp"
#include "fd_fpk/functionals/passage_values.hpp"
#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"
#include "problem/effective_potential.hpp"
#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Returns the cells below the barrier, and the cells of the stationary density: the same cells,
// continued beyond the barrier.
struct GridsBelowAndBeyondBarrier {
  PhasePlaneGrid below, whole;
};
std::optional<GridsBelowAndBeyondBarrier> make_passage_grids(
    const DisplacementPassageProblem& passage, const FiniteVolumeOptions& options,
    std::string& failure) {
  PhasePlaneBox box = passage.box;
  box.x1_max = passage.barrier;
  FiniteVolumeOptions to_barrier = options;
  to_barrier.x1_max = std::nullopt;
  PlaneDiscretisation below = discretise_density_equation(passage.problem, to_barrier, box);
  // The orbit that grazes the barrier needs narrower cells than the stationary density.
  constexpr double kFewestBelowBarrier = 40;
  const int fewest = static_cast<int>(std::ceil(kFewestBelowBarrier * options.refinement));
  if (below.failure.empty() && !options.nx && below.grid.nx() < fewest) {
    to_barrier.nx = fewest;
    below = discretise_density_equation(passage.problem, to_barrier, box);
  }
  if (!below.failure.empty()) {
    failure = below.failure;
    return std::nullopt;
  }
  const GridAxis& x1 = below.grid.x1;
  std::vector<double> faces = x1.faces();
  // Beyond the barrier the cell widths increase by 15 % from cell to cell, up to the automatic cell
  // width of the stationary density.
  constexpr double kWidening = 1.15;
  double width = x1.cell_width(x1.cell_count() - 1);
  const double widest =
      std::max(width, automatic_cell_widths(passage.problem, options, box.lengths).x1);
  const double end = passage.box.x1_max;
  while (end - faces.back() > 1.5 * width) {
    faces.push_back(faces.back() + width);
    width = std::min(kWidening * width, widest);
  }
  faces.push_back(end);
  const auto right =
      passage.problem.system.right_wall() ? AxisEndCondition::boundary : AxisEndCondition::vacuum;
  return GridsBelowAndBeyondBarrier{
      {x1.with_right_end_condition(AxisEndCondition::barrier), below.grid.x2},
      {GridAxis(std::move(faces), x1.left_end_condition(), right), below.grid.x2}};
}

// Returns the row of weights that evaluates cell averages at a position of an axis.
Eigen::RowVectorXd point_value_weights(const GridAxis& axis, int order, double x) {
  const std::vector<double>& faces = axis.faces();
  const auto cell = std::clamp<std::ptrdiff_t>(
      std::upper_bound(faces.begin(), faces.end(), x) - faces.begin() - 1, 0,
      axis.cell_count() - 1);
  const int c = static_cast<int>(cell);
  const std::array fraction{(x - axis.face_position(c)) / axis.cell_width(c)};
  return point_value_operator(axis, averaging_stencil_size(order), fraction).row(c);
}

// Returns the weights of the velocity cells in the mean of a function of the velocity right after
// the first impulse on a mass at rest. A wall at the position of the mass reflects the velocity of
// impulses towards the wall.
Eigen::RowVectorXd mean_after_first_impulse_weights(const DisplacementPassageProblem& passage,
                                                    const GridAxis& x2, int order) {
  constexpr int kParts = 8;  // number of parts of a cell; the centre of each part has a value
  std::vector<double> centres;
  for (int k = 0; k < kParts; ++k) centres.push_back((k + 0.5) / kParts);
  const AxisOperator values = point_value_operator(x2, averaging_stencil_size(order), centres);
  const problem::ImpulseLaw& law = passage.problem.impulses.amplitude_law();
  const auto& wall = passage.problem.system.left_wall();
  const bool on_wall = wall && passage.start->y <= wall->position;
  // An impulse Y changes the velocity by b Y, with b = 1 unless the impulses are parametric.
  const auto& factor = passage.problem.impulse_factor;
  const double b = factor ? (*factor)(passage.start->y, 0) : 1;
  const auto impulse_probability = [&](double v) {
    const double probability = law.cumulative_probability(v / b);
    return b > 0 ? probability : 1 - probability;
  };
  // Returns the probability of velocities up to v.
  const auto cumulative = [&](double v) {
    if (!on_wall) return impulse_probability(v);
    if (v <= 0) return 0.0;
    return impulse_probability(v) - impulse_probability(-problem::speed_before_impact(*wall, v));
  };
  Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(x2.cell_count());
  for (int j = 0; j < x2.cell_count(); ++j) {
    for (int k = 0; k < kParts; ++k) {
      const double low = x2.face_position(j) + x2.cell_width(j) * k / kParts;
      const double high = x2.face_position(j) + x2.cell_width(j) * (k + 1) / kParts;
      const double probability = cumulative(high) - cumulative(low);
      for (AxisOperator::InnerIterator e(values, j * kParts + k); e; ++e) {
        weights(e.col()) += probability * e.value();
      }
    }
  }
  return weights;
}

// Returns the functional of cell averages that evaluates the survival probability or the mean
// passage time at the initial state. From rest under impulses, the functional evaluates the mean
// over the states after the first impulse.
Eigen::VectorXd start_value_functional(const DisplacementPassageProblem& passage,
                                       const PhasePlaneGrid& grid, int order) {
  const Eigen::RowVectorXd of_x1 = point_value_weights(grid.x1, order, passage.start->y);
  const Eigen::RowVectorXd of_x2 = passage.waiting_rate > 0
                                       ? mean_after_first_impulse_weights(passage, grid.x2, order)
                                       : point_value_weights(grid.x2, order, passage.start->ydot);
  const Eigen::MatrixXd weights = of_x2.transpose() * of_x1;
  return Eigen::Map<const Eigen::VectorXd>(weights.data(), weights.size());
}

// Returns the mean times from the starts in all cells below the barrier, in physical coordinates.
// @pre the wall frame is not mirrored
transform::MeanPassageTimeMap mean_time_map(const DisplacementPassageProblem& passage,
                                            const PhasePlaneGrid& below,
                                            const ReducedResolvent& model) {
  const problem::WallFrame& frame = passage.problem.frame;
  assert(!frame.mirrored);
  transform::MeanPassageTimeMap map{.y_edges = {}, .v_edges = below.x2.faces(), .averages = {}};
  for (const double x : below.x1.faces()) map.y_edges.push_back(frame.physical_y(x));
  // The integral of the survival probability times the areas over all times is the vector
  // (0 - L^T)^-1 areas.
  const Eigen::VectorXd times = model.shifted_solution(0).cwiseQuotient(below.cell_areas());
  map.averages.assign(times.begin(), times.end());
  return map;
}

// Returns the values by the transposed matrix of finite volumes.
PassageResultOnGrid finite_volume_passage_on_grid(const DisplacementPassageProblem& passage,
                                                  double refinement,
                                                  const std::vector<double>& times, double shift,
                                                  const base::Deadline& deadline) {
  const problem::Problem& problem = passage.problem;
  const FiniteVolumeOptions options = with_refined_cells(passage.options, refinement);
  const int order = transport_order(options);
  PassageResultOnGrid result;
  FunctionalValuesOnGrid& level = result.values_on_grid;
  const auto grids = make_passage_grids(passage, options, level.failure);
  if (!grids) return result;
  const auto& [below, whole] = *grids;
  level.nx = below.nx();
  level.nv = below.v_cell_count();

  const PlaneDiscretisation of_whole =
      discretise_excitation_on_same_grid(problem, options, {.grid = whole, .excitation = {}});
  level.failure = check_well_posedness(problem, options, of_whole).ill_posed_reason;
  if (!level.failure.empty()) return result;
  const FokkerPlanckOperator op_whole = fokker_planck_operator(problem, options, of_whole);
  Preconditioner for_whole(problem.system, passage.scales.slowest_decay_rate, of_whole.excitation,
                           options.impact, whole, order);
  const NullVectorResult stationary =
      find_null_vector(op_whole, for_whole, initial_gaussian(whole, passage.scales), deadline);
  if (!stationary.averages) {
    level.failure = stationary.failure;
    return result;
  }
  constexpr double kLargestResidual = 1e-8;  // in frequencies of the oscillator
  if (!(op_whole.stationarity_residual(*stationary.averages) <
        kLargestResidual * passage.scales.frequency)) {
    level.failure = "GMRES did not find the stationary density; use another grid";
    return result;
  }
  const Eigen::VectorXd p = stationary.averages->head(below.size());
  const Eigen::VectorXd areas = below.cell_areas();
  const double probability = areas.dot(p);

  const PlaneDiscretisation of_below =
      discretise_excitation_on_same_grid(problem, options, {.grid = below, .excitation = {}});
  const FokkerPlanckOperator op = fokker_planck_operator(problem, options, of_below);
  Preconditioner preconditioner(problem.system, passage.scales.slowest_decay_rate,
                                of_below.excitation, options.impact, below, order);
  // The vector exp(L^T t) areas is the survival probability times the cell areas.
  const ShiftedLinearSystem system(op, &preconditioner, below.v_cell_count(), order, shift,
                                   OperatorTransposition::yes);
  ReducedResolvent model(system, areas);
  PassageInitialConditions starts{
      .from_point = {}, .from_stationary = p / probability, .waiting_rate = passage.waiting_rate};
  if (passage.start) {
    starts.from_point = start_value_functional(passage, below, order).cwiseQuotient(areas);
  }
  Eigen::VectorXd last = compute_passage_values(model, starts, times, passage.options.accuracy,
                                                deadline, level.failure);
  if (last.size() == 0) return result;
  // Rice's rate is the flux of the stationary density through the barrier.
  last(kRiceRate) = wall_speed_moment(below, p, order, 1, AxisEnd::right);
  last(kProbabilityBelow) = probability;
  level.values = last;
  result.mean_passage_times_by_start = mean_time_map(passage, below, model);
  return result;
}

// Returns the box of the stationary density, enlarged for motion that reaches a barrier or that
// starts at the initial state. Motion that leaves the wall at the speed w has hit the wall at the
// speed w/r.
PhasePlaneBox passage_box(const problem::Problem& problem, const problem::MotionScales& scales,
                          const FiniteVolumeOptions& options, double barrier,
                          const std::optional<double>& lower_barrier,
                          const std::optional<transform::PassageStartState>& start,
                          const base::Deadline& deadline) {
  constexpr double kImpulseDeviations = 5.5;
  constexpr double kBeyond =
      0.5;  // shortest part of the box beyond the barrier, in standard deviations of y
  PhasePlaneBox box = stationary_box(problem, scales, options, deadline);
  const problem::EffectivePotential potential(problem.system);
  const auto& wall = problem.system.left_wall();
  double lowest = wall ? wall->position : 0;
  for (const double y : potential.extremum_positions()) {
    if (y < barrier && potential(y) < potential(lowest)) lowest = y;
  }
  double energy = std::max(0.0, potential(barrier) - potential(lowest));
  if (lower_barrier) energy = std::max(energy, potential(*lower_barrier) - potential(lowest));
  const double energy_of_start =
      start ? start->ydot * start->ydot / 2 + potential(start->y) - potential(lowest) : 0;
  if (energy_of_start > energy) {
    energy = energy_of_start;
    const auto half_cycles =
        problem::UndampedOrbits(problem).half_cycles(energy + potential(lowest));
    if (!wall) box.x1_min = std::min(box.x1_min, half_cycles.front().left);
  }
  const double speed = std::sqrt(2 * energy);
  const double restitution = wall ? std::max(0.1, wall->restitution_at_speed(speed)) : 1;
  const auto& law = problem.impulses.amplitude_law();
  const double of_impulse =
      problem.impulses.is_acting()
          ? std::abs(law.mean()) + kImpulseDeviations * law.amplitude_standard_deviation()
          : 0;
  box.x2_max = std::max(box.x2_max, speed / restitution + of_impulse);
  box.x1_max = std::max(box.x1_max, barrier + kBeyond * scales.displacement_deviation);
  if (lower_barrier && !wall) {
    box.x1_min = std::min(box.x1_min, *lower_barrier - kBeyond * scales.displacement_deviation);
  }
  if (const auto& right = problem.system.right_wall()) box.x1_max = right->position;
  return box;
}

}  // namespace

transform::FirstPassageResult solve_passage(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options,
                                            const transform::PassageBarrier& barrier,
                                            std::vector<double> times,
                                            std::optional<transform::PassageStartState> start) {
  assert(!barrier.is_energy());
  validate(options);
  const base::Stopwatch stopwatch;
  transform::FirstPassageResult passage{.id = solution_id(options)};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const double level = transformed.frame.wall_coordinate(barrier.level);
  std::optional<double> lower_level;
  if (barrier.lower_level) lower_level = transformed.frame.wall_coordinate(*barrier.lower_level);
  const std::string grid_reason = barrier_grid_unsupported_reason(transformed, options);
  for (const std::string& reason :
       {transient_unsupported_reason(transformed, options),
        problem::barrier_unsupported_reason(transformed, level),
        lower_level ? problem::barrier_unsupported_reason(transformed, *lower_level) : "",
        lower_level ? grid_reason : ""}) {
    if (passage.reason.empty()) passage.reason = reason;
  }
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  const base::Deadline deadline(options.max_seconds);
  const problem::MotionScales scales = problem::motion_scales(transformed);
  FiniteVolumeOptions with_order = options;
  with_order.order = options.order.value_or(automatic_scheme_order(transformed));
  if (!has_linearised_scales(transformed))
    with_order.wall_density *= box_edge_density_factor(transformed);
  start = transform::passage_start_state(transformed, level, start, lower_level);
  const auto rest = problem::rest_displacement(transformed, level, lower_level);
  const bool is_at_rest = start && rest && start->y == *rest && start->ydot == 0;
  const bool has_noise =
      transformed.noise.is_acting() || options.equation == DensityEquation::white;
  const bool waits = transformed.impulses.is_acting() && !transformed.noise.is_acting() &&
                     options.equation == DensityEquation::kf;
  const DisplacementPassageProblem below{
      .problem = transformed,
      .options = with_order,
      .scales = scales,
      .barrier = level,
      .lower_barrier = lower_level,
      .start = start,
      .waiting_rate = waits && is_at_rest ? transformed.impulses.arrival_rate() : 0,
      .box = passage_box(transformed, scales, with_order, level, lower_level, start, deadline)};
  if (level <= below.box.x1_min) {
    passage.status = Status::not_offered;
    passage.reason = "the stationary probability below the barrier is negligible";
    return passage;
  }
  // Without noise the mean passage time jumps, and the finite volumes are as accurate as the finite
  // differences, whose impact condition is exact.
  const bool uses_differences =
      lower_level ||
      (has_noise && options.impact == problem::ImpactCondition::map && grid_reason.empty());
  // Across the orbits that graze two barriers the mean passage time without noise jumps, and finite
  // differences converge with the order 1.
  const int order = lower_level && !has_noise ? 1 : kPassageOrder;
  const double shift = survival_resolvent_shift(scales);
  solve_passage_on_grids(
      [&](double refinement, const std::vector<double>& at) {
        return uses_differences
                   ? barrier_passage_on_grid(below, refinement, at, deadline)
                   : finite_volume_passage_on_grid(below, refinement, at, shift, deadline);
      },
      options, order, std::move(times), start.has_value(), uses_differences ? "nodes" : "cells",
      deadline, passage);
  passage.seconds = stopwatch.seconds();
  return passage;
}

}  // namespace fpkcheck::fd_fpk
