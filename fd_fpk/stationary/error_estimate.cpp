#include "fd_fpk/stationary/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/stationary/status_checks.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::kRefinementRatio;
using transform::Moments;
using transform::Solution;
using transform::Status;

const transform::GridDensity& grid_of(const Solution& solution) {
  return std::get<transform::GridDensity>(*solution.density);
}

// Merges bins narrower than `width`, except for those next to 0 and at the end.
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

// Difference of the marginals on the cells of the finer grid, merged up to a practical resolution: in
// the cells of a spike no two grids agree.
transform::LevelDifference level_difference(const Result& coarser, const Result& finer) {
  constexpr double kNarrowest = 0.02;  // in units of the root mean square
  const auto& [y_edges, v_edges, averages] = grid_of(finer.solution);
  const auto& moments = finer.solution.moments;
  // E[y^2] may be large because the motion is far from y = 0.
  const double extent = std::min(std::sqrt(moments.y2), y_edges.back() - y_edges.front());
  const auto y = merge_narrow_bins(y_edges, kNarrowest * extent);
  const auto v = merge_narrow_bins(v_edges, kNarrowest * std::sqrt(moments.v2));
  const auto of = [&](const Result& result) {
    transform::GridLevel level = transform::level(result.solution, y, v);
    level.impact_rate = result.summary.impact_rate;
    return level;
  };
  return transform::level_difference(of(coarser), of(finer));
}

// The options of a grid with cells narrower by `factor`, without automatic changes.
Options with_refined_cells(Options options, double factor) {
  options.refine_unresolved = false;
  options.refinement *= factor;
  if (options.nx) options.nx = static_cast<int>(std::lround(*options.nx * factor));
  if (options.nv) options.nv = 2 * static_cast<int>(std::lround(*options.nv * factor / 2));
  return options;
}

Options direct(Options options) {
  options.stepper = Stepper::direct;
  return options;
}

Options with_box_of(Options options, const Summary& summary) {
  options.x1_max = summary.x1_max;
  options.x2_max = summary.x2_max;
  return options;
}

// The grid and box may differ from the options by automatic changes: all levels of an estimate use
// the final values. In separate boxes their difference would include more than the discretisation
// error.
Options with_used_grid(Options options, const Summary& summary) {
  options.refinement = summary.refinement;
  if (options.transport != Transport::characteristics) {
    options.origin_refinement = summary.origin_refinement;
  }
  return with_box_of(options, summary);
}

// Order of the scheme; along characteristics the mass in a cell is piecewise linear.
int order_of_convergence(const Options& options) {
  constexpr int kAlongCharacteristics = 2;
  return options.transport == Transport::characteristics ? kAlongCharacteristics
                                                         : order_of(options);
}

// Relative error of the second moments.
double second_moment_error(const Moments& error, const Moments& moments) {
  return std::max(error.y2 / moments.y2, error.v2 / moments.v2);
}

double largest_error(const ErrorEstimate& error, const Moments& moments) {
  return std::max({error.y_l1, error.ydot_l1, second_moment_error(error.moments, moments)});
}

double l1(const ErrorEstimate& error) { return std::max(error.y_l1, error.ydot_l1); }

void add_estimate(Result& fine, const Solution& coarser, const ErrorEstimate& error) {
  fine.summary.error = error;
  for (std::size_t k = 0; k < error.rest_probabilities.size(); ++k) {
    fine.solution.atoms[k].error_estimate = error.rest_probabilities[k];
  }
  if (error.has_limit) {
    fine.solution.extrapolation = {*coarser.density, error.factor};
  }
}

// Truncation error of the box: the change of the moments on the same cells in a larger box. A
// refinement of the cells does not show this error. Zero if the larger box gives no density.
Moments box_truncation_error(const SolveOnOneGrid& solve, const Options& of_cells,
                             const Result& in_box) {
  Moments moved;
  const auto& [solution, summary] = in_box;
  if (!summary.enlarged_box) return moved;
  Options options = direct(of_cells);
  options.x1_max = summary.enlarged_box->box.x1_max;
  options.x2_max = summary.enlarged_box->box.x2_max;
  options.nx = summary.enlarged_box->nx;
  options.nv = summary.enlarged_box->nv;
  const Result enlarged_box = solve(options);
  if (!enlarged_box.solution.density) return moved;
  for (const auto& named : transform::kMoments) {
    moved.*named.moment =
        std::abs(enlarged_box.solution.moments.*named.moment - solution.moments.*named.moment);
  }
  return moved;
}

// Along characteristics the order is unknown, and two levels may overestimate the order of the
// next. An error estimate below the residual of a balance would contradict the balance: the
// dissipated power is proportional to E[v^2], and so to E[y^2], the mean force to E[y].
Moments raise_to_balance_residuals(Moments error, const Result& fine) {
  const auto& [solution, summary] = fine;
  if (summary.transport != Transport::characteristics) return error;
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

// The estimate from three levels, plus the truncation error of the box.
ErrorEstimate estimate(const Options& options, const Result& coarse, const Result& middle,
                       const Result& fine, const Moments& box_truncation) {
  ErrorEstimate error = estimate_error(coarse, middle, fine, order_of_convergence(options));
  error.moments = raise_to_balance_residuals(error.moments, fine);
  for (const auto& named : transform::kMoments) {
    error.moments.*named.moment +=
        box_truncation.*named.moment + fine.summary.moments_outside_box.*named.moment;
  }
  error.box_truncation = box_truncation;
  return error;
}

// The most accurate result so far, as `not_converged`, when a finer grid gave none.
Result not_converged_result(Result best, const Options& options, const std::string& reason) {
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

// Least ratio of the times of successive levels; the observed ratio counts where it is larger.
constexpr double kTimeRatio = 2.5;

// True if two levels have the same grid (the minimum number of cells): they show no error.
bool have_same_cells(const Summary& first, const Summary& second) {
  return first.nx > 0 && first.nx == second.nx && first.nv == second.nv;
}

// Expected time of a grid from its number of cells: the same on any machine and at any load, so
// that the choice of the grid is reproducible.
double expected_seconds(const Summary& on) {
  constexpr double kOfCell = 4e-5, kAlongCharacteristics = 1e-5;
  return on.nx * on.nv *
         (on.transport == Transport::characteristics ? kAlongCharacteristics : kOfCell);
}

// True if the remaining levels, extrapolated from the last three, are expected to take at most an
// eighth of the time limit.
bool is_accuracy_attainable(const ErrorEstimate& error, const Summary& last, const Options& options,
                            double accuracy, const Deadline& deadline) {
  constexpr double kTimeFraction = 8, kLeastOrder = 0.5;
  const double order =
      std::clamp(error.observed_order, kLeastOrder, 1.0 * order_of_convergence(options));
  const double missing = std::max(
      1.0, std::ceil(std::log(l1(error) / accuracy) / (order * std::log(kRefinementRatio))));
  // Sum of a geometric series.
  const double levels = kTimeRatio * (std::pow(kTimeRatio, missing) - 1) / (kTimeRatio - 1);
  return kTimeFraction * levels * expected_seconds(last) <= deadline.total_seconds();
}

}  // namespace

bool is_better(const Result& first, const Result& second) {
  const auto rank = [](const Result& result) {
    return result.solution.is_ok() ? 3 : result.summary.error ? 2 : result.solution.density ? 1 : 0;
  };
  if (rank(first) != rank(second)) return rank(first) > rank(second);
  return first.summary.error && second.summary.error &&
         l1(*first.summary.error) < l1(*second.summary.error);
}

ErrorEstimate estimate_error(const Result& coarse, const Result& middle, const Result& fine,
                             int order) {
  const transform::LevelDifference last = level_difference(middle, fine);
  const auto known = transform::richardson_estimate(level_difference(coarse, middle), last,
                                                    kRefinementRatio, order);
  return {.y_l1 = known.error.y_l1,
          .ydot_l1 = known.error.ydot_l1,
          .moments = known.error.moments,
          .observed_order = known.orders.l1,
          .extrapolated = transform::limit(fine.solution.moments, last, known.factor),
          .factor = known.factor,
          .rest_probabilities = known.rest_probabilities,
          .impact_rate = known.impact_rate,
          .has_limit = transform::has_limit(known.orders.l1, order)};
}

Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options) {
  Result fine = solve(options);
  if (!fine.solution.density) return fine;
  const Options used = with_used_grid(options, fine.summary);
  // The coarser grids are faster, and a solution needs an error estimate.
  const Result middle = solve(direct(with_refined_cells(used, 1 / kRefinementRatio)));
  const Options coarsest =
      direct(with_refined_cells(used, 1 / (kRefinementRatio * kRefinementRatio)));
  const Result coarse = solve(coarsest);
  const bool same = have_same_cells(coarse.summary, middle.summary) ||
                    have_same_cells(middle.summary, fine.summary);
  if (middle.solution.density && coarse.solution.density && !same) {
    add_estimate(
        fine, middle.solution,
        estimate(options, coarse, middle, fine, box_truncation_error(solve, coarsest, coarse)));
  }
  check_error(options, fine);
  return fine;
}

Result refine_until_deadline(const SolveOnOneGrid& solve, const Options& options,
                             const Deadline& deadline, const RefinementGoal& goal) {
  double slower = kTimeRatio;
  const Stopwatch stopwatch;
  Result best = solve_with_error_estimate(solve, options);
  if (!best.summary.error) return best;
  // The three grids together take about 1 + 1/2.5 + 1/6 times as long as the finest, and the larger
  // box twice as long as the last.
  double seconds = stopwatch.seconds() / (best.summary.enlarged_box ? 1.9 : 1.6);
  Options level = direct(with_used_grid(options, best.summary));
  // Of the last three levels the two coarser.
  const Options before = with_refined_cells(level, 1 / kRefinementRatio);
  Result middle = best;
  std::optional<Result> coarse;
  // Finer cells do not repair a box that is too small.
  while (best.solution.status != Status::failed &&
         (l1(*best.summary.error) > goal.accuracy || (goal.until_ok && !best.solution.is_ok()))) {
    // Where the accuracy is out of range, only a solution that is not yet ok is improved.
    if (best.solution.is_ok() && !is_accuracy_attainable(*best.summary.error, middle.summary,
                                                         options, goal.accuracy, deadline)) {
      break;
    }
    if (!deadline.has_time_for(slower * seconds)) break;
    level = with_refined_cells(level, kRefinementRatio);
    const Stopwatch of_level;
    Result fine = solve(level);
    slower = std::max(kTimeRatio, of_level.seconds() / seconds);
    seconds = of_level.seconds();
    if (!fine.solution.density) break;
    if (!coarse) coarse = solve(before);
    if (!coarse->solution.density) break;
    add_estimate(fine, middle.solution,
                 estimate(options, *coarse, middle, fine, best.summary.error->box_truncation));
    check_error(options, fine);
    coarse = std::exchange(middle, fine);
    if (is_better(fine, best)) best = std::move(fine);
  }
  return best;
}

Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options,
                          const Deadline& deadline) {
  constexpr double kFirst = 0.5;  // refinement of the coarsest grid
  // Deficit of the observed order above which the origin limits the order.
  constexpr double kOrdersMissing = 1.5;
  // Fraction of the tolerance allowed for the truncation by the box, which only a larger box
  // reduces.
  constexpr double kWalls = 0.25, kLeastOnWall = 1e-12;
  Options level = with_refined_cells(options, kFirst);
  level.wall_density = std::min(options.wall_density, *options.tolerance / 100);
  std::array<std::optional<Result>, 3> last;  // coarse, middle, fine
  std::optional<Result> estimated;            // finest result before grading
  Moments box_truncation;
  bool box_found = false;
  const auto stop = [&](const std::string& reason) {
    // A graded grid without an estimate does not replace a uniform grid that has an estimate.
    const bool newer = last[2] && (last[2]->summary.error || !estimated);
    return not_converged_result(newer ? *last[2] : *estimated, options, reason);
  };
  double seconds = 0, slower = kTimeRatio;  // time of the last level; time ratio of the next level
  while (true) {
    if ((last[2] || estimated) && !deadline.has_time_for(slower * seconds)) {
      return stop(fmt::format("it needs about {:.2g} s, more than the rest of max_seconds",
                              slower * seconds));
    }
    const Stopwatch of_level;
    Result result = solve(direct(level));
    slower = std::max(kTimeRatio, seconds > 0 ? of_level.seconds() / seconds : 0);
    seconds = of_level.seconds();
    if (!result.solution.density) {
      return last[2] || estimated ? stop(result.solution.reason) : result;
    }
    if (!box_found) {
      last[2] = std::move(result);
      box_truncation = box_truncation_error(solve, direct(level), *last[2]);
      const double excess = second_moment_error(box_truncation, last[2]->solution.moments) /
                            (kWalls * *options.tolerance);
      const bool free = !options.x1_max || !options.x2_max;
      box_found = excess <= 1 || !free || level.wall_density <= kLeastOnWall;
      if (!box_found) {
        level.wall_density *= std::min(0.1, 1 / excess);
        continue;  // repeat with the same cells in a larger box
      }
      level = with_box_of(level, last[2]->summary);
    } else {
      std::rotate(last.begin(), last.begin() + 1, last.end());
      last[2] = std::move(result);
    }
    if (last[0] && !have_same_cells(last[0]->summary, last[1]->summary)) {
      const auto error = estimate(options, *last[0], *last[1], *last[2], box_truncation);
      add_estimate(*last[2], last[1]->solution, error);
      if (largest_error(error, last[2]->solution.moments) <= *options.tolerance) {
        if (options.stepper == Stepper::direct) {
          check_error(options, *last[2]);
          return *last[2];
        }
        level.stepper = options.stepper;
        Result stepped = solve(level);
        if (!stepped.solution.density && deadline.has_passed()) stepped = *last[2];
        if (stepped.solution.density) add_estimate(stepped, last[1]->solution, error);
        check_error(options, stepped);
        return stepped;
      }
      if (options.transport != Transport::characteristics &&
          error.observed_order < order_of(options) - kOrdersMissing &&
          last[2]->summary.origin_refinement == 1) {
        level.origin_refinement = kOriginRefinement;
        estimated = std::move(last[2]);
        last = {};
        continue;  // same width far out, three new levels
      }
    }
    level = with_refined_cells(level, kRefinementRatio);
  }
}

}  // namespace fpkcheck::fd_fpk
