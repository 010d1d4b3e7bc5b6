#include "fd_fpk/functionals/barrier_passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "fd_fpk/functionals/barrier_grid.hpp"
#include "fd_fpk/functionals/density_interpolation.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Returns the grid with the automatic numbers of nodes times `refinement`. In v the nodes resolve
// the change of the velocity by one impulse, by the noise in one period, or by the noise while the
// mass crosses the strip.
BarrierGrid make_barrier_grid(const DisplacementPassageProblem& passage,
                              const BackwardEquationExcitation& excitation, double refinement) {
  constexpr double kFewest = 66, kMost = 160, kNodesPerDeviation = 8;
  constexpr double kColumnsPerRow = 2. / 3;
  using End = PassageStrip::LowerEnd;
  const auto& wall = passage.problem.system.left_wall();
  const PassageStrip strip{
      .lower_end = passage.lower_barrier ? End::barrier
                   : wall                ? End::wall
                                         : End::box,
      .lower = passage.lower_barrier.value_or(wall ? wall->position : passage.box.x1_min),
      .upper = passage.barrier,
      .largest_speed = passage.box.x2_max};
  const double period = 2 * std::numbers::pi / passage.scales.frequency;
  const double by_noise = std::min(std::sqrt(2 * excitation.diffusion * period),
                                   std::cbrt(excitation.diffusion * (strip.upper - strip.lower)));
  const double by_impulse =
      excitation.impulse_rate > 0 ? excitation.law->amplitude_standard_deviation() : 0;
  const double nodes = refinement * std::clamp(kNodesPerDeviation * strip.largest_speed /
                                                   std::hypot(by_noise, by_impulse),
                                               kFewest, kMost);
  return {passage.problem, excitation, strip, static_cast<int>(std::ceil(kColumnsPerRow * nodes)),
          2 * static_cast<int>(std::ceil(nodes / 2))};
}

// Returns the stationary rate of the motion out of the strip, through one barrier or both.
double stationary_exit_rate(const DisplacementPassageProblem& passage, const BarrierGrid& grid,
                            const DensityInterpolation& density) {
  double rate = 0;
  for (int j = 0; j < grid.velocity_count(); ++j) {
    const double v = grid.velocity(j), weight = std::abs(v) * grid.velocity_weight(j);
    if (v > 0) rate += weight * density(passage.barrier, v);
    if (v < 0 && passage.lower_barrier) rate += weight * density(*passage.lower_barrier, v);
  }
  return rate;
}

// Computes the functionals of the probability u that the motion leaves the strip at the upper
// barrier, A u + g = 0. With w = (s - A)^-1 g the solution is u = w + s (0 - A)^-1 w.
// @return the values of the functionals; empty with a reason in `failure`
Eigen::VectorXd upper_exit_probabilities(const ShiftedLinearSystem& system,
                                         const Eigen::VectorXd& upper_exit_terms,
                                         const std::vector<Eigen::VectorXd>& functionals,
                                         const base::Deadline& deadline, std::string& failure) {
  constexpr int kStep = 10, kMost = 120;
  constexpr double kTolerance = 1e-6;
  const auto w = system.solve(upper_exit_terms, kTolerance, deadline, failure);
  if (!w) return {};
  ReducedResolvent model(system, *w);
  Eigen::VectorXd last;
  while (model.size() < kMost) {
    if (!model.add_krylov_basis_vectors(kStep, deadline)) {
      failure = model.failure_reason();
      return {};
    }
    const Eigen::VectorXd u = *w + system.resolvent_shift() * model.shifted_solution(0);
    Eigen::VectorXd values(functionals.size());
    for (std::size_t k = 0; k < functionals.size(); ++k) {
      values(static_cast<Eigen::Index>(k)) = functionals[k].dot(u);
    }
    if (last.size() > 0 && (values - last).cwiseAbs().maxCoeff() < kTolerance) return values;
    last = values;
  }
  failure = "the Krylov space does not determine the exit probabilities; use mcs";
  return {};
}

transform::MeanPassageTimeMap barrier_mean_time_map(const problem::WallFrame& frame,
                                                    const BarrierGrid& grid,
                                                    const Eigen::VectorXd& mean_passage_times) {
  assert(!frame.mirrored);
  transform::MeanPassageTimeMap map{
      .y_edges = {},
      .v_edges = grid.velocity_edges(),
      .averages = {mean_passage_times.begin(), mean_passage_times.end()}};
  for (const double x : grid.displacement_edges()) map.y_edges.push_back(frame.physical_y(x));
  return map;
}

}  // namespace

std::string barrier_grid_unsupported_reason(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options) {
  if (options.equation != DensityEquation::kf && options.equation != DensityEquation::white) {
    return "two barriers need the equation kf or white";
  }
  if (options.impact != problem::ImpactCondition::map) {
    return "two barriers need the exact impact condition; use a method without -delta";
  }
  return problem.impulse_factor ? "two barriers do not support impulse.factor; use mcs" : "";
}

PassageResultOnGrid barrier_passage_on_grid(const DisplacementPassageProblem& passage,
                                            double refinement, const std::vector<double>& times,
                                            const base::Deadline& deadline) {
  PassageResultOnGrid result;
  FunctionalValuesOnGrid& level = result.values_on_grid;
  const BackwardEquationExcitation excitation =
      BackwardEquationExcitation::of_equation(passage.problem, passage.options.equation);
  const BarrierGrid grid = make_barrier_grid(passage, excitation, refinement);
  level.nx = grid.displacement_count();
  level.nv = grid.velocity_count();
  // The matrix itself contains dense blocks of the impulses and may need much memory.
  level.failure = ShiftedLinearSystem::large_factors_reason(grid.size(), level.nv, kDefaultOrder);
  if (!level.failure.empty()) return result;
  const DirectStationarySolution stationary =
      compute_direct_solution(passage.problem, {.scales = passage.scales, .box = passage.box},
                              with_refined_cells(passage.options, refinement), deadline);
  if (!stationary.averages || !stationary.converged) {
    level.failure = stationary.averages
                        ? "GMRES did not find the stationary density; use another grid"
                        : stationary.failure;
    return result;
  }
  const DensityInterpolation density(stationary.discretisation.grid, *stationary.averages);
  PassageInitialConditions starts{.from_stationary = grid.integration_weights(),
                                  .waiting_rate = passage.waiting_rate};
  for (int i = 0; i < level.nx; ++i) {
    for (int j = 0; j < level.nv; ++j) {
      starts.from_stationary(grid.grid_node_index(i, j)) *=
          density(grid.displacement(i), grid.velocity(j));
    }
  }
  const double probability = starts.from_stationary.sum();
  constexpr double kLargestExcess = 1e-3;  // of probabilities above 1, due to interpolation
  if (!(probability > 0 && probability <= 1 + kLargestExcess)) {
    level.failure = fmt::format(
        "the computed stationary probability of the states before the passage is {:.3g}",
        probability);
    return result;
  }
  starts.from_stationary /= probability;
  if (const auto& start = passage.start) {
    starts.from_point = passage.waiting_rate > 0
                            ? grid.mean_after_impulse_weights(start->y)
                            : grid.interpolation_weights_at_state(start->y, start->ydot);
  }
  BarrierGrid::BackwardSystem backward = grid.backward_system();
  const FokkerPlanckOperator op{.local = std::move(backward.matrix),
                                .exchange = {},
                                .areas = Eigen::VectorXd::Ones(grid.size())};
  const ShiftedLinearSystem system(op, nullptr, level.nv, kDefaultOrder,
                                   survival_resolvent_shift(passage.scales));
  ReducedResolvent model(system, op.areas);
  Eigen::VectorXd values = compute_passage_values(model, starts, times, passage.options.accuracy,
                                                  deadline, level.failure);
  if (values.size() == 0) return result;
  values(kRiceRate) = stationary_exit_rate(passage, grid, density);
  values(kProbabilityBelow) = probability;
  if (passage.lower_barrier) {
    std::vector<Eigen::VectorXd> functionals{starts.from_stationary};
    if (starts.from_point) functionals.push_back(*starts.from_point);
    const Eigen::VectorXd exits = upper_exit_probabilities(system, backward.upper_exit_terms,
                                                           functionals, deadline, level.failure);
    if (exits.size() == 0) return result;
    values(kUpperExitFromStationary) = exits(0);
    if (starts.from_point) values(kUpperExitFromPoint) = exits(1);
  }
  level.values = values;
  result.mean_passage_times_by_start =
      barrier_mean_time_map(passage.problem.frame, grid, model.shifted_solution(0));
  return result;
}

}  // namespace fpkcheck::fd_fpk
