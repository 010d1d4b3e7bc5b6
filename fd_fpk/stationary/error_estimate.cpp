#include "fd_fpk/stationary/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fd_fpk/operator/discretisation.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::kLevelRatio;
using transform::Moments;
using transform::Solution;
using transform::Status;

const transform::GridDensity& grid_of(const Solution& solution) {
  return std::get<transform::GridDensity>(*solution.density);
}

// On the cells of the finer one.
transform::Change change(const Solution& coarser, const Solution& finer) {
  const auto& [y_edges, v_edges, averages] = grid_of(finer);
  return transform::change(level(coarser, y_edges, v_edges), level(finer, y_edges, v_edges));
}

// The options of a grid whose cells are `factor` times narrower, without automatic changes.
Options refined(Options options, double factor) {
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

double worst(const ErrorEstimate& error, const Moments& moments) {
  return std::max(
      {error.y_l1, error.ydot_l1, error.moments.y2 / moments.y2, error.moments.v2 / moments.v2});
}

void add_estimate(Result& fine, const Solution& coarser, const ErrorEstimate& error) {
  fine.summary.error = error;
  if (error.observed_order >= transform::kLeastOrderOfALimit) {
    fine.solution.extrapolation = {*coarser.density, error.factor};
  }
}

void require_small(const ErrorEstimate& error, Solution& solution) {
  const double l1 = std::max(error.y_l1, error.ydot_l1);
  if (solution.status != Status::ok || l1 <= kUnresolvedError) return;
  solution.status = Status::inadmissible;
  solution.reason = fmt::format(
      "the discretisation error is estimated as {:.1g} in L1, with an observed order of {:.1f}: the "
      "grid does not resolve the density (ask for a tolerance, or refine)",
      l1, error.observed_order);
}

// The best there is when a finer grid gave nothing.
Result given_up(Result best, const Options& options, const std::string& reason) {
  best.solution.status = Status::not_converged;
  const std::string reached = best.summary.error
                                  ? fmt::format("the error estimate is {:.1e}",
                                                worst(*best.summary.error, best.solution.moments))
                                  : std::string("there is no error estimate yet");
  best.solution.reason =
      fmt::format("{} on {} x {} cells, {:.1e} was asked for (the next grid: {})", reached,
                  best.summary.nx, best.summary.nv, *options.tolerance, reason);
  return best;
}

}  // namespace

ErrorEstimate estimate_error(const Solution& coarse, const Solution& middle, const Solution& fine,
                             int order) {
  const transform::Change last = change(middle, fine);
  const auto known = transform::richardson(change(coarse, middle), last, kLevelRatio, order);
  return {.y_l1 = known.error.y_l1,
          .ydot_l1 = known.error.ydot_l1,
          .moments = known.error.moments,
          .observed_order = known.orders.l1,
          .extrapolated = transform::limit(fine.moments, last, known.factor),
          .factor = known.factor};
}

Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options) {
  Result fine = solve(options);
  if (!fine.solution.density) return fine;
  // An automatic grid may have been refined on the way: the coarser ones follow the one it became.
  Options used = options;
  used.refinement = fine.summary.refinement;
  used.origin_refinement = fine.summary.origin_refinement;
  const Result middle = solve(direct(refined(used, 1 / kLevelRatio)));
  const Result coarse = solve(direct(refined(used, 1 / (kLevelRatio * kLevelRatio))));
  if (middle.solution.density && coarse.solution.density) {
    add_estimate(fine, middle.solution,
                 estimate_error(coarse.solution, middle.solution, fine.solution, options.order));
    require_small(*fine.summary.error, fine.solution);
  }
  return fine;
}

Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options) {
  constexpr double kFirst = 0.5;          // refinement of the coarsest grid
  constexpr double kOrdersMissing = 1.5;  // when the origin is held to limit the order
  Options level = refined(options, kFirst);
  level.wall_density = std::min(options.wall_density, *options.tolerance / 100);
  std::array<std::optional<Result>, 3> last;  // coarse, middle, fine
  std::optional<Result> estimated;            // the finest before the cells were graded
  while (true) {
    Result result = solve(direct(level));
    if (!result.solution.density) {
      if (!last[2] && !estimated) return result;
      // Graded grids that have no estimate yet do not replace uniform ones that have.
      const bool newer = last[2] && (last[2]->summary.error || !estimated);
      return given_up(newer ? *last[2] : *estimated, options, result.solution.reason);
    }
    std::ranges::rotate(last, last.begin() + 1);
    last[2] = std::move(result);
    if (last[0]) {
      const auto error =
          estimate_error(last[0]->solution, last[1]->solution, last[2]->solution, options.order);
      add_estimate(*last[2], last[1]->solution, error);
      if (worst(error, last[2]->solution.moments) <= *options.tolerance) {
        if (options.stepper == Stepper::direct) return *last[2];
        level.stepper = options.stepper;
        Result stepped = solve(level);
        if (stepped.solution.density) add_estimate(stepped, last[1]->solution, error);
        return stepped;
      }
      if (error.observed_order < options.order - kOrdersMissing &&
          last[2]->summary.origin_refinement == 1) {
        level.origin_refinement = kRefinedOrigin;
        estimated = std::move(last[2]);
        last = {};
        continue;  // the same width far out, three levels anew
      }
    }
    level = refined(level, kLevelRatio);
  }
}

}  // namespace fpkcheck::fd_fpk
