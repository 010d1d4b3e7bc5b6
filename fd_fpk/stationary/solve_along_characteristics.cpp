#include "fd_fpk/stationary/solve_on_one_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/characteristics/characteristic_grid.hpp"
#include "fd_fpk/characteristics/embedded_chain.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/status_checks.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Order of accuracy of moments and fluxes that are computed from cell averages by parabolas.
constexpr int kOrderOfObservables = 3;
constexpr int kCharacteristicsPerCell = 8;

struct StationarySolutionOnGrid {
  PhasePlaneGrid grid;
  StationaryCellMasses found;
};

StationarySolutionOnGrid solve_in_box(const problem::Problem& problem,
                                      const problem::MotionScales& scales,
                                      const FiniteVolumeOptions& options, const PhasePlaneBox& box,
                                      const base::Deadline& deadline) {
  PhasePlaneGrid grid = characteristic_grid(problem, scales, options, box);
  StationaryCellMasses found =
      stationary_cell_masses(problem, scales, grid, kCharacteristicsPerCell, deadline);
  return {.grid = std::move(grid), .found = std::move(found)};
}

// Masses of the marginal distributions in the cells of displacement and in the cells of speed.
struct MarginalCellMasses {
  Eigen::VectorXd of_y, of_speed;
};
MarginalCellMasses marginal_masses(const StationarySolutionOnGrid& grid_solution) {
  const int nx = grid_solution.grid.nx(), nv = grid_solution.grid.v_cell_count();
  const Eigen::Map<const Eigen::MatrixXd> masses(grid_solution.found.masses->data(), nv, nx);
  const Eigen::VectorXd of_v = masses.rowwise().sum();
  return {.of_y = masses.colwise().sum(),
          .of_speed = of_v.tail(nv / 2) + of_v.head(nv / 2).reverse()};
}

// Largest accepted mass in the end cells of a computational box, where mass that would leave the
// computational box accumulates.
constexpr double kMaxMassAtEnd = 1e-6;
double mass_at_end(const StationarySolutionOnGrid& grid_solution,
                   const MarginalCellMasses& marginal_masses) {
  const Eigen::VectorXd& of_y = marginal_masses.of_y;
  const auto is_open = [](AxisEndCondition end) { return end == AxisEndCondition::vacuum; };
  const double on_left = is_open(grid_solution.grid.x1.left_end_condition()) ? of_y(0) : 0;
  const double on_right =
      is_open(grid_solution.grid.x1.right_end_condition()) ? of_y(of_y.size() - 1) : 0;
  return std::max(
      {on_left, on_right, marginal_masses.of_speed(marginal_masses.of_speed.size() - 1)});
}

// Returns the position of the first cell face beyond which the mass is at most `negligible`. The
// mass beyond a cell face is the sum of the absolute values of cell masses, since the masses of
// wide cells oscillate in a steep tail. If the last cell contains more mass than `negligible`, the
// result is the position of the last face.
double end_of_support(const GridAxis& axis, const Eigen::VectorXd& masses, double negligible) {
  double beyond = 0;
  int last = axis.cell_count();
  while (last > 1) {
    beyond += std::abs(masses(last - 1));
    if (beyond > negligible) break;
    --last;
  }
  return axis.face_position(last);
}

// Returns the largest distance from y = 0 of a point with significant density, on both sides of an
// axis without walls.
double end_of_support_in_y(const GridAxis& axis, const Eigen::VectorXd& masses, double negligible) {
  const double right = end_of_support(axis, masses, negligible);
  if (axis.left_end_condition() != AxisEndCondition::vacuum) return right;
  double beyond = 0;
  int first = 0;
  while (first + 1 < axis.cell_count()) {
    beyond += std::abs(masses(first));
    if (beyond > negligible) break;
    ++first;
  }
  return std::max(right, -axis.face_position(first));
}

// Returns a computational box, determined on wide cells, that contains all but a negligible part of
// the mass. After the deadline the computational box is enlarged only if the mass in the cells at
// its ends exceeds kMaxMassAtEnd, because a solution with more mass at the ends would be rejected.
PhasePlaneBox characteristics_box(const problem::Problem& problem,
                                  const problem::MotionScales& scales,
                                  const FiniteVolumeOptions& options,
                                  const base::Deadline& deadline) {
  constexpr double kCoarse = 0.4, kNegligible = 1e-10, kWider = 1.5;
  // With a limit cycle, errors of GMRES of about 1e-10 (characteristics/embedded_chain.cpp) spread
  // over the whole computational box, since the motion far from the limit cycle is slow.
  constexpr double kNegligibleAroundCycle = 1e-9;
  // If the mass at the ends of the computational box exceeds kLargeMass, the computational box is
  // enlarged by the larger factor kFastWidening.
  constexpr double kLargeMass = 1e-3, kFastWidening = 3;
  // Approximate ratio of the computing times in an enlarged and in the previous computational box
  constexpr double kTimeRatio = 1.5;
  constexpr int kMostTimes = 6;
  PhasePlaneBox box = initial_characteristic_box(problem, scales, options);
  const bool given_y = options.x1_max || problem.system.right_wall(),
             given_v = options.x2_max.has_value();
  if (given_y && given_v) return box;
  FiniteVolumeOptions coarse = options;
  coarse.nx = coarse.nv = std::nullopt;
  coarse.refinement = kCoarse;
  for (int time = 0; time < kMostTimes; ++time) {
    const base::Stopwatch stopwatch;
    const StationarySolutionOnGrid grid_solution =
        solve_in_box(problem, scales, coarse, box, deadline);
    if (!grid_solution.found.masses) return box;
    const MarginalCellMasses masses = marginal_masses(grid_solution);
    const double negligible =
        grid_solution.found.rest.empty() ? kNegligibleAroundCycle : kNegligible;
    const double y = end_of_support_in_y(grid_solution.grid.x1, masses.of_y, negligible);
    const double v = end_of_support(grid_solution.grid.speed_axis(), masses.of_speed, negligible);
    const bool wider_y = !given_y && y >= box.x1_max;
    const bool wider_v = !given_v && v >= box.x2_max;
    const double beyond = mass_at_end(grid_solution, masses);
    const bool is_acceptable = beyond <= kMaxMassAtEnd;
    if (is_acceptable && (wider_y || wider_v) &&
        !deadline.has_time_for(kTimeRatio * stopwatch.seconds()))
      break;
    const double wider = beyond > kLargeMass ? kFastWidening : kWider;
    if (!given_y) box.x1_max = wider_y ? wider * box.x1_max : y;
    if (!problem.system.left_wall()) box.x1_min = -box.x1_max;
    if (!given_v) box.x2_max = wider_v ? wider * box.x2_max : v;
    if (!wider_y && !wider_v) break;
  }
  return box;
}

// Adds the atoms of mass at rest in contact and their contributions to the moments to the solution.
void add_atoms(const problem::Problem& problem, const StationarySolutionOnGrid& grid_solution,
               transform::Solution& solution) {
  auto& moments = solution.moments;
  for (std::size_t k = 0; k < grid_solution.found.rest.size(); ++k) {
    const RestPoint& point = grid_solution.found.rest[k];
    if (!point.contact) continue;
    const double probability = grid_solution.found.at_rest[k];
    solution.atoms.push_back(
        {.y = point.y, .probability = probability, .standard_error = {}, .error_estimate = {}});
    const double y = problem.frame.physical_y(point.y);
    moments.y1 += probability * y;
    moments.y2 += probability * y * y;
    moments.y4 += probability * y * y * y * y;
    solution.mass += probability;
  }
}

void set_results(const problem::Problem& problem, const problem::MotionScales& scales,
                 const StationarySolutionOnGrid& grid_solution, const Eigen::VectorXd& averages,
                 FiniteVolumeResult& result) {
  auto& [solution, summary] = result;
  const double rate = problem.impulses.arrival_rate();
  const auto& [left, right] = grid_solution.found.impacts;
  solution.density = grid_density_from_averages(grid_solution.grid, averages);
  solution.moments =
      physical_moments(problem.frame, grid_solution.grid, averages, kOrderOfObservables);
  solution.mass = grid_solution.grid.cell_areas().dot(averages);
  solution.min_density = averages.minCoeff() / averages.maxCoeff();
  add_atoms(problem, grid_solution, solution);
  summary.wall = relative_box_edge_density(scales, grid_solution.grid, averages);
  summary.impact_rate = rate * (left.number + right.number);
  double displacement_at_rest = 0;
  for (std::size_t k = 0; k < grid_solution.found.rest.size(); ++k) {
    const RestPoint& point = grid_solution.found.rest[k];
    const double mass = grid_solution.found.at_rest[k];
    if (point.contact) {
      displacement_at_rest += mass * point.y;
      summary.impact_rate = std::numeric_limits<double>::infinity();
    } else {
      // At an equilibrium on a wall, small oscillations continue with impacts of negligible speed.
      summary.rest_mass += mass;
      summary.impact_rate += mass * point.impact_rate;
    }
  }
  const auto in_frame = moments(grid_solution.grid, averages, kOrderOfObservables);
  const problem::PowerBalanceTerms terms{
      .mean_velocity = in_frame.v1,
      .mean_square_velocity = in_frame.v2,
      .left_impact_loss = problem::impact_energy_loss_rate(
          problem.system.left_wall(), problem::ImpactCondition::map, rate * left.energy),
      .right_impact_loss = problem::impact_energy_loss_rate(
          problem.system.right_wall(), problem::ImpactCondition::map, rate * right.energy),
      .mean_damping_power = mean_damping_power(problem.system, in_frame, grid_solution.grid,
                                               averages, kOrderOfObservables)};
  solution.energy_residual = problem::power_balance_residual(problem, terms);
  if (grid_solution.found.rest.empty()) {
    summary.exchanged_power =
        std::max(1.0, mean_absolute_damping_power(problem.system, grid_solution.grid, averages,
                                                  kOrderOfObservables) /
                          problem::power_balance(problem, terms).input);
  }
  summary.balances = balance_residuals(
      problem, grid_solution.grid, averages, kOrderOfObservables,
      {.left = problem::impact_momentum_rate(problem.system.left_wall(), rate * left.momentum),
       .right = problem::impact_momentum_rate(problem.system.right_wall(), rate * right.momentum),
       .displacement_at_rest = displacement_at_rest});
}

}  // namespace

FiniteVolumeResult solve_along_characteristics(const problem::Problem& problem,
                                               const problem::MotionScales& scales,
                                               const FiniteVolumeOptions& options,
                                               const base::Deadline& deadline) {
  FiniteVolumeResult result;
  auto& [solution, summary] = result;
  const PhasePlaneBox box = characteristics_box(problem, scales, options, deadline);
  const base::Stopwatch stopwatch;
  const StationarySolutionOnGrid grid_solution =
      solve_in_box(problem, scales, options, box, deadline);
  summary.nx = grid_solution.grid.nx();
  summary.nv = grid_solution.grid.v_cell_count();
  summary.x1_max = grid_solution.grid.x1_max();
  summary.x2_max = grid_solution.grid.x2_max();
  summary.refinement = options.refinement;
  summary.transport = TransportScheme::characteristics;
  summary.balances_limit_errors = true;
  summary.visits = grid_solution.found.visits;
  summary.krylov_iterations = grid_solution.found.iterations;
  summary.krylov_seconds = stopwatch.seconds();
  if (!grid_solution.found.masses) {
    solution.status = Status::failed;
    solution.reason = grid_solution.found.failure;
    return result;
  }
  summary.residual =
      grid_solution.found.residual * problem.impulses.arrival_rate() / scales.frequency;
  set_results(problem, scales, grid_solution,
              grid_solution.found.masses->cwiseQuotient(grid_solution.grid.cell_areas()), result);
  solution.status = Status::ok;
  if (const double beyond = mass_at_end(grid_solution, marginal_masses(grid_solution));
      beyond > kMaxMassAtEnd) {
    solution.status = Status::failed;
    solution.reason = fmt::format(
        "the box y <= {:.3g}, |y'| <= {:.3g} is too small: {:.1e} of the probability is in the "
        "cells at its end; increase y-max and v-max",
        grid_solution.grid.x1_max(), grid_solution.grid.x2_max(), beyond);
    return result;
  }
  check_resolution(options, result);
  if (must_satisfy_balances(problem)) check_balances(result);
  return result;
}

}  // namespace fpkcheck::fd_fpk
