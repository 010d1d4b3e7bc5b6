#include "fd_fpk/stationary/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "fd_fpk/stationary/status_checks.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::kRefinementRatio;
using transform::Moments;
using transform::Solution;
using transform::Status;

const transform::GridDensity& grid_density_of(const Solution& solution) {
  return std::get<transform::GridDensity>(*solution.density);
}

// Merges neighbouring bins of a marginal density to bins at least as wide as `width`, except that a
// bin next to 0 or at an end of the axis may be narrower.
std::vector<double> merge_narrow_bins(const std::vector<double>& edges, double width) {
  std::vector<double> kept;
  for (const double edge : edges) {
    if (edge == 0) {
      while (!kept.empty() && kept.back() < 0 && kept.back() > -width) kept.pop_back();
      kept.push_back(edge);
    } else if (kept.empty() || edge >= kept.back() + width) {
      kept.push_back(edge);
    }
  }
  kept.back() = edges.back();
  return kept;
}

// Returns the differences of moments and marginal densities between two solutions, on the cells of
// the finer grid. Cells narrower than kNarrowest are merged, because the densities on two grids
// never agree in the narrow cells of a density spike.
transform::GridLevelDifference grid_level_difference(const FiniteVolumeResult& coarser,
                                                     const FiniteVolumeResult& finer) {
  constexpr double kNarrowest = 0.02;  // smallest bin width, in units of the root mean square
  const auto& [y_edges, v_edges, averages] = grid_density_of(finer.solution);
  const auto& moments = finer.solution.moments;
  // The root mean square of y may exceed the extent of the grid, if the density is far from y = 0.
  const double extent = std::min(std::sqrt(moments.y2), y_edges.back() - y_edges.front());
  const auto y = merge_narrow_bins(y_edges, kNarrowest * extent);
  const auto v = merge_narrow_bins(v_edges, kNarrowest * std::sqrt(moments.v2));
  const auto of = [&](const FiniteVolumeResult& result) {
    transform::GridLevelSolution level = transform::make_grid_level(result.solution, y, v);
    level.impact_rate = result.summary.impact_rate;
    return level;
  };
  return transform::grid_level_difference(of(coarser), of(finer));
}

FiniteVolumeOptions with_direct_solver(FiniteVolumeOptions options) {
  options.stepper = StationarySolver::direct;
  return options;
}

FiniteVolumeOptions with_box_ends(FiniteVolumeOptions options, double x1_max, double x2_max) {
  options.x1_max = x1_max;
  options.x2_max = x2_max;
  return options;
}

FiniteVolumeOptions with_box_of(const FiniteVolumeOptions& options,
                                const FiniteVolumeSummary& summary) {
  return with_box_ends(options, summary.x1_max, summary.x2_max);
}

// Returns the options with the computational box and the grid refinement that the solver finally
// used. All grids of an error estimate have the same computational box, since different boxes would
// add to the differences of the solutions.
FiniteVolumeOptions with_used_grid(FiniteVolumeOptions options,
                                   const FiniteVolumeSummary& summary) {
  options.refinement = summary.refinement;
  if (options.transport != TransportScheme::characteristics) {
    options.origin_refinement = summary.origin_refinement;
  }
  return with_box_of(options, summary);
}

// Along characteristics the order of convergence is 2, since the density is linear in each cell.
int order_of_convergence(const FiniteVolumeOptions& options) {
  constexpr int kAlongCharacteristics = 2;
  return options.transport == TransportScheme::characteristics ? kAlongCharacteristics
                                                               : transport_order(options);
}

double second_moment_error(const Moments& error, const Moments& moments) {
  return std::max(error.y2 / moments.y2, error.v2 / moments.v2);
}

double largest_error(const DiscretisationErrorEstimate& error, const Moments& moments) {
  return std::max({error.y_l1, error.ydot_l1, second_moment_error(error.moments, moments)});
}

double largest_l1_error(const DiscretisationErrorEstimate& error) {
  return std::max(error.y_l1, error.ydot_l1);
}

void add_error_estimate(FiniteVolumeResult& fine, const Solution& coarser,
                        const DiscretisationErrorEstimate& error) {
  fine.summary.error = error;
  for (std::size_t k = 0; k < error.rest_probabilities.size(); ++k) {
    fine.solution.atoms[k].error_estimate = error.rest_probabilities[k];
  }
  if (error.has_richardson_limit) {
    fine.solution.extrapolation = {*coarser.density, error.factor};
  }
}

// Returns the changes of the moments when the computational box is enlarged; zero without a density
// in the enlarged computational box.
Moments box_truncation_error(const SolveOnOneGrid& solve, const FiniteVolumeOptions& of_cells,
                             const FiniteVolumeResult& in_box) {
  Moments moved;
  const auto& [solution, summary] = in_box;
  if (!summary.enlarged_box) return moved;
  FiniteVolumeOptions options = with_direct_solver(of_cells);
  options.x1_max = summary.enlarged_box->box.x1_max;
  options.x2_max = summary.enlarged_box->box.x2_max;
  options.nx = summary.enlarged_box->nx;
  options.nv = summary.enlarged_box->nv;
  const FiniteVolumeResult enlarged_box = solve(options);
  if (!enlarged_box.solution.density) return moved;
  for (const auto& named : transform::kMoments) {
    moved.*named.moment =
        std::abs(enlarged_box.solution.moments.*named.moment - solution.moments.*named.moment);
  }
  return moved;
}

// Raises the error estimates of the moments at least to the residuals of the balances of power and
// momentum, for solutions along characteristics and for formulas of the force. The observed order
// of convergence may be too high for solutions along characteristics, and for a force given by a
// formula with kinks. A relative error of a moment below the relative residual of a balance would
// contradict the balance. The dissipated power is assumed proportional to E[v^2] and to E[y^2], and
// the mean force is assumed proportional to E[y].
Moments raise_to_balance_residuals(Moments error, const FiniteVolumeResult& fine) {
  const auto& [solution, summary] = fine;
  if (!summary.balances_limit_errors) return error;
  const double power = std::abs(solution.energy_residual);
  const double momentum = std::abs(summary.balances.momentum.value_or(0));
  const auto at_least = [&, &moments = solution.moments](double Moments::*moment, double part) {
    error.*moment = std::max(error.*moment, part * std::abs(moments.*moment));
  };
  at_least(&Moments::y1, momentum);
  at_least(&Moments::y2, power);
  at_least(&Moments::v2, power);
  at_least(&Moments::y4, 2 * power);
  at_least(&Moments::v4, 2 * power);
  return error;
}

DiscretisationErrorEstimate estimate_with_box_truncation(const FiniteVolumeOptions& options,
                                                         const FiniteVolumeResult& coarse,
                                                         const FiniteVolumeResult& middle,
                                                         const FiniteVolumeResult& fine,
                                                         const Moments& box_truncation) {
  DiscretisationErrorEstimate error =
      estimate_error_from_three_grids(coarse, middle, fine, order_of_convergence(options));
  error.moments = raise_to_balance_residuals(error.moments, fine);
  for (const auto& named : transform::kMoments) {
    error.moments.*named.moment +=
        box_truncation.*named.moment + fine.summary.moments_outside_box.*named.moment;
  }
  error.box_truncation = box_truncation;
  return error;
}

// Returns the most accurate result so far, with the status `not_converged`.
FiniteVolumeResult not_converged_result(FiniteVolumeResult best, const FiniteVolumeOptions& options,
                                        const std::string& reason) {
  best.solution.status = Status::not_converged;
  const std::string reached =
      best.summary.error ? fmt::format("error estimate {:.1e}",
                                       largest_error(*best.summary.error, best.solution.moments))
                         : std::string("no error estimate");
  best.solution.reason =
      fmt::format("{} on {} x {} cells, requested {:.1e}: the next grid failed: {}", reached,
                  best.summary.nx, best.summary.nv, *options.tolerance, reason);
  return best;
}

// Smallest ratio of the computing times on successive grids of a refinement
constexpr double kTimeRatio = 2.5;

// The difference of solutions on equal numbers of cells is no measure of the discretisation error.
bool have_same_cells(const FiniteVolumeSummary& first, const FiniteVolumeSummary& second) {
  return first.nx > 0 && first.nx == second.nx && first.nv == second.nv;
}

// Returns an estimate of the computing time that does not depend on the machine, so that the choice
// of grids is reproducible.
double expected_seconds(const FiniteVolumeSummary& summary) {
  constexpr double kOfCell = 4e-5, kAlongCharacteristics = 1e-5;
  return summary.nx * summary.nv *
         (summary.transport == TransportScheme::characteristics ? kAlongCharacteristics : kOfCell);
}

// Returns whether all further grids up to kAutomaticGridTargetL1Error are expected to take at most
// an eighth of the time limit. The number of further grids is extrapolated from the error estimate
// of the last three grids.
bool is_target_accuracy_attainable(const DiscretisationErrorEstimate& error,
                                   const FiniteVolumeSummary& last,
                                   const FiniteVolumeOptions& options,
                                   const base::Deadline& deadline) {
  constexpr double kTimeFraction = 8, kLeastOrder = 0.5;
  const double order =
      std::clamp(error.observed_order, kLeastOrder, 1.0 * order_of_convergence(options));
  const double missing =
      std::max(1.0, std::ceil(std::log(largest_l1_error(error) / kAutomaticGridTargetL1Error) /
                              (order * std::log(kRefinementRatio))));
  // The computing time on all further grids, in units of the time on the last grid, is a geometric
  // series.
  const double levels = kTimeRatio * (std::pow(kTimeRatio, missing) - 1) / (kTimeRatio - 1);
  return kTimeFraction * levels * expected_seconds(last) <= deadline.limit_seconds();
}

// Results of a solver on the three grids of the first error estimate.
struct ResultsOnThreeGrids {
  FiniteVolumeResult fine;  // with an error estimate, if all three grids have densities
  std::optional<FiniteVolumeResult> middle;  // absent if the fine grid has no density
  double fine_seconds = 0;
};

FiniteVolumeOptions coarser_grid(const FiniteVolumeOptions& options, double factor) {
  return with_direct_solver(with_refined_cells(options, 1 / factor));
}

bool have_same_box(const FiniteVolumeResult& first, const FiniteVolumeResult& second) {
  constexpr double kRounding = 1e-12;
  if (!first.solution.density || !second.solution.density) return false;
  const auto have_same_ends = [](const std::vector<double>& a, const std::vector<double>& b) {
    const double difference =
        std::max(std::abs(a.front() - b.front()), std::abs(a.back() - b.back()));
    return difference <= kRounding * (a.back() - a.front());
  };
  const auto &of_first = grid_density_of(first.solution),
             &of_second = grid_density_of(second.solution);
  return have_same_ends(of_first.y_edges, of_second.y_edges) &&
         have_same_ends(of_first.v_edges, of_second.v_edges);
}

// Solves the problem on the grid of the options and on two coarser grids in one computational box,
// in parallel if the computational box is known. The cells of the coarser grids are wider than the
// finest cells by the factors kRefinementRatio and kRefinementRatio^2. If the solution on the fine
// grid has moved the ends of the computational box or refined the cells, the two solutions on
// coarser grids are repeated.
ResultsOnThreeGrids solve_on_three_grids(const SolveOnOneGrid& solve,
                                         const FiniteVolumeOptions& options,
                                         const std::optional<PhasePlaneBox>& known_box) {
  constexpr double kMiddle = kRefinementRatio, kCoarse = kRefinementRatio * kRefinementRatio;
  ResultsOnThreeGrids grids;
  FiniteVolumeResult &fine = grids.fine, middle, coarse;
  Moments box_truncation;
  const auto solve_on_fine_grid = [&] {
    const base::Stopwatch stopwatch;
    fine = solve(options);
    grids.fine_seconds = stopwatch.seconds();
  };
  if (known_box) {
    const FiniteVolumeOptions in_box = with_box_ends(options, known_box->x1_max, known_box->x2_max);
    base::parallel_for(3, base::kOneThreadPerProcessor, [&](std::size_t level) {
      if (level == 0) solve_on_fine_grid();
      if (level == 1) middle = solve(coarser_grid(in_box, kMiddle));
      if (level == 2) coarse = solve(coarser_grid(in_box, kCoarse));
    });
  } else {
    solve_on_fine_grid();
  }
  if (!fine.solution.density) return grids;
  const auto are_coarser_grids_valid = [&] {
    return fine.summary.refinement == options.refinement && have_same_box(middle, fine) &&
           have_same_box(coarse, fine) &&
           middle.summary.origin_refinement == fine.summary.origin_refinement &&
           coarse.summary.origin_refinement == fine.summary.origin_refinement;
  };
  if (!known_box || !are_coarser_grids_valid()) {
    // Solutions on two coarser grids are always computed, since no solution may lack an error
    // estimate.
    const FiniteVolumeOptions used = with_used_grid(options, fine.summary),
                              coarsest = coarser_grid(used, kCoarse);
    base::parallel_for(2, base::kOneThreadPerProcessor, [&](std::size_t level) {
      if (level == 0) {
        middle = solve(coarser_grid(used, kMiddle));
      } else {
        coarse = solve(coarsest);
        box_truncation = box_truncation_error(solve, coarsest, coarse);
      }
    });
  }
  const bool same = have_same_cells(coarse.summary, middle.summary) ||
                    have_same_cells(middle.summary, fine.summary);
  if (middle.solution.density && coarse.solution.density && !same) {
    add_error_estimate(fine, middle.solution,
                       estimate_with_box_truncation(options, coarse, middle, fine, box_truncation));
  }
  check_error_estimate(options, fine);
  grids.middle = std::move(middle);
  return grids;
}

}  // namespace

FiniteVolumeOptions with_refined_cells(FiniteVolumeOptions options, double factor) {
  options.refine_unresolved = false;
  options.refinement *= factor;
  if (options.nx) options.nx = static_cast<int>(std::lround(*options.nx * factor));
  if (options.nv) options.nv = 2 * static_cast<int>(std::lround(*options.nv * factor / 2));
  return options;
}

bool is_preferable_result(const FiniteVolumeResult& first, const FiniteVolumeResult& second) {
  const auto rank = [](const FiniteVolumeResult& result) {
    return result.solution.has_status_ok() ? 3
           : result.summary.error          ? 2
           : result.solution.density       ? 1
                                           : 0;
  };
  if (rank(first) != rank(second)) return rank(first) > rank(second);
  return first.summary.error && second.summary.error &&
         largest_l1_error(*first.summary.error) < largest_l1_error(*second.summary.error);
}

DiscretisationErrorEstimate estimate_error_from_three_grids(const FiniteVolumeResult& coarse,
                                                            const FiniteVolumeResult& middle,
                                                            const FiniteVolumeResult& fine,
                                                            int order) {
  assert(coarse.solution.density && middle.solution.density && fine.solution.density);
  const transform::GridLevelDifference last = grid_level_difference(middle, fine);
  const auto known = transform::richardson_estimate(grid_level_difference(coarse, middle), last,
                                                    kRefinementRatio, order);
  return {.y_l1 = known.error.y_l1,
          .ydot_l1 = known.error.ydot_l1,
          .moments = known.error.moments,
          .observed_order = known.orders.l1,
          .extrapolated = transform::richardson_limit(fine.solution.moments, last, known.factor),
          .factor = known.factor,
          .rest_probabilities = known.rest_probabilities,
          .impact_rate = known.impact_rate,
          .has_richardson_limit = transform::has_richardson_limit(known.orders.l1, order)};
}

FiniteVolumeResult solve_with_error_estimate(const SolveOnOneGrid& solve,
                                             const FiniteVolumeOptions& options,
                                             const std::optional<PhasePlaneBox>& known_box) {
  return solve_on_three_grids(solve, options, known_box).fine;
}

FiniteVolumeResult refine_grid_until_deadline(const SolveOnOneGrid& solve,
                                              const FiniteVolumeOptions& options,
                                              const base::Deadline& deadline,
                                              GridRefinementGoal goal,
                                              const std::optional<PhasePlaneBox>& known_box) {
  double slower = kTimeRatio;
  ResultsOnThreeGrids grids = solve_on_three_grids(solve, options, known_box);
  FiniteVolumeResult best = std::move(grids.fine);
  if (!best.summary.error) return best;
  double seconds = grids.fine_seconds;
  FiniteVolumeOptions level = with_direct_solver(with_used_grid(options, best.summary));
  // The results `middle` and `coarse` are the solutions on the two coarser of the last three grids.
  FiniteVolumeResult middle = best, coarse = std::move(*grids.middle);
  // The status `failed` means a too small computational box, which a finer grid does not correct.
  while (best.solution.status != Status::failed &&
         (largest_l1_error(*best.summary.error) > kAutomaticGridTargetL1Error ||
          (goal == GridRefinementGoal::accurate_and_ok && !best.solution.has_status_ok()))) {
    // If the error kAutomaticGridTargetL1Error is not attainable in time, the grid is refined only
    // until the status of the solution is `ok`, and not at all if no grid can have this status.
    if ((best.solution.has_status_ok() ||
         has_negative_density_on_all_grids(options, best.solution.min_density)) &&
        !is_target_accuracy_attainable(*best.summary.error, middle.summary, options, deadline)) {
      break;
    }
    if (!deadline.has_time_for(slower * seconds)) break;
    level = with_refined_cells(level, kRefinementRatio);
    const base::Stopwatch of_level;
    FiniteVolumeResult fine = solve(level);
    slower = std::max(kTimeRatio, of_level.seconds() / seconds);
    seconds = of_level.seconds();
    if (!fine.solution.density) break;
    add_error_estimate(fine, middle.solution,
                       estimate_with_box_truncation(options, coarse, middle, fine,
                                                    best.summary.error->box_truncation));
    check_error_estimate(options, fine);
    coarse = std::exchange(middle, fine);
    if (is_preferable_result(fine, best)) best = std::move(fine);
  }
  return best;
}

FiniteVolumeResult refine_grid_to_tolerance(const SolveOnOneGrid& solve,
                                            const FiniteVolumeOptions& options,
                                            const base::Deadline& deadline) {
  constexpr double kFirst = 0.5;  // value of FiniteVolumeOptions::refinement for the coarsest grid
  // Deficit of the observed order of convergence above which the error of the density at the origin
  // is assumed to dominate
  constexpr double kOrdersMissing = 1.5;
  // Fraction of the error tolerance permitted for truncation by the computational box; only a
  // larger computational box reduces the truncation error
  constexpr double kWalls = 0.25, kLeastOnWall = 1e-12;
  FiniteVolumeOptions level = with_refined_cells(options, kFirst);
  level.wall_density = std::min(options.wall_density, *options.tolerance / 100);
  std::array<std::optional<FiniteVolumeResult>, 3>
      last;                                     // results on the last three grids, coarsest first
  std::optional<FiniteVolumeResult> estimated;  // result on the finest ungraded grid
  Moments box_truncation;
  bool box_found = false;
  const auto stop = [&](const std::string& reason) {
    // A result without an error estimate does not replace a result with an error estimate.
    const bool newer = last[2] && (last[2]->summary.error || !estimated);
    return not_converged_result(newer ? *last[2] : *estimated, options, reason);
  };
  // Computing time on the last grid, and expected ratio of the computing times on the next and on
  // the last grid
  double seconds = 0, slower = kTimeRatio;
  while (true) {
    if ((last[2] || estimated) && !deadline.has_time_for(slower * seconds)) {
      return stop(fmt::format("it needs about {:.2g} s, more than the rest of max_seconds",
                              slower * seconds));
    }
    const base::Stopwatch of_level;
    FiniteVolumeResult result = solve(with_direct_solver(level));
    slower = std::max(kTimeRatio, seconds > 0 ? of_level.seconds() / seconds : 0);
    seconds = of_level.seconds();
    if (!result.solution.density) {
      return last[2] || estimated ? stop(result.solution.reason) : result;
    }
    if (!box_found) {
      last[2] = std::move(result);
      box_truncation = box_truncation_error(solve, with_direct_solver(level), *last[2]);
      const double excess = second_moment_error(box_truncation, last[2]->solution.moments) /
                            (kWalls * *options.tolerance);
      const bool free = !options.x1_max || !options.x2_max;
      box_found = excess <= 1 || !free || level.wall_density <= kLeastOnWall;
      if (!box_found) {
        level.wall_density *= std::min(0.1, 1 / excess);
        continue;  // the next solution uses the present cells in an enlarged box
      }
      level = with_box_of(level, last[2]->summary);
    } else {
      std::rotate(last.begin(), last.begin() + 1, last.end());
      last[2] = std::move(result);
    }
    if (last[0] && !have_same_cells(last[0]->summary, last[1]->summary)) {
      const auto error =
          estimate_with_box_truncation(options, *last[0], *last[1], *last[2], box_truncation);
      add_error_estimate(*last[2], last[1]->solution, error);
      if (largest_error(error, last[2]->solution.moments) <= *options.tolerance) {
        if (options.stepper == StationarySolver::direct) {
          check_error_estimate(options, *last[2]);
          return *last[2];
        }
        level.stepper = options.stepper;
        FiniteVolumeResult stepped = solve(level);
        if (!stepped.solution.density && deadline.has_deadline_passed()) stepped = *last[2];
        if (stepped.solution.density) add_error_estimate(stepped, last[1]->solution, error);
        check_error_estimate(options, stepped);
        return stepped;
      }
      if (options.transport != TransportScheme::characteristics &&
          error.observed_order < transport_order(options) - kOrdersMissing &&
          last[2]->summary.origin_refinement == 1) {
        level.origin_refinement = kOriginRefinement;
        estimated = std::move(last[2]);
        last = {};
        continue;  // three new, graded grids follow, with unchanged cell widths far from the origin
      }
    }
    level = with_refined_cells(level, kRefinementRatio);
  }
}

}  // namespace fpkcheck::fd_fpk
