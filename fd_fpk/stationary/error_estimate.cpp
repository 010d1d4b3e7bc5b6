#include "fd_fpk/stationary/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/stationary/judgement.hpp"
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

// Edges that leave no bin narrower than `width`, but for what is next to 0 and the end.
std::vector<double> no_narrower(const std::vector<double>& edges, double width) {
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

// On the cells of the finer one, where they are not narrower than what anybody looks at: on the
// cells into which a spike falls no two grids agree.
transform::Change change(const Solution& coarser, const Solution& finer) {
  constexpr double kNarrowest = 0.02;  // root mean squares
  const auto& [y_edges, v_edges, averages] = grid_of(finer);
  const auto& moments = finer.moments;
  // E[y^2] may be that of a motion far from y = 0.
  const double extent = std::min(std::sqrt(moments.y2), y_edges.back() - y_edges.front());
  const auto y = no_narrower(y_edges, kNarrowest * extent);
  const auto v = no_narrower(v_edges, kNarrowest * std::sqrt(moments.v2));
  return transform::change(level(coarser, y, v), level(finer, y, v));
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

// An automatic grid may have been refined on the way, or its box found: other levels follow what it
// became.
Options as_used(Options options, const Summary& summary) {
  options.refinement = summary.refinement;
  if (options.transport == Transport::characteristics) {
    options.x1_max = summary.x1_max;
    options.x2_max = summary.x2_max;
  } else {
    options.origin_refinement = summary.origin_refinement;
  }
  return options;
}

// Of the scheme; the transport along characteristics spreads a cell's mass linearly.
int order_of(const Options& options) {
  constexpr int kAlongCharacteristics = 2;
  return options.transport == Transport::characteristics ? kAlongCharacteristics : options.order;
}

double worst(const ErrorEstimate& error, const Moments& moments) {
  return std::max(
      {error.y_l1, error.ydot_l1, error.moments.y2 / moments.y2, error.moments.v2 / moments.v2});
}

double l1(const ErrorEstimate& error) { return std::max(error.y_l1, error.ydot_l1); }

void add_estimate(Result& fine, const Solution& coarser, const ErrorEstimate& error) {
  fine.summary.error = error;
  if (error.observed_order >= transform::kLeastOrderOfALimit) {
    fine.solution.extrapolation = {*coarser.density, error.factor};
  }
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

// A level takes at least as many times as long as the one before, more where the last did.
constexpr double kSlower = 2.5;

}  // namespace

bool better(const Result& one, const Result& other) {
  const auto rank = [](const Result& result) {
    return result.solution.is_ok() ? 3 : result.summary.error ? 2 : result.solution.density ? 1 : 0;
  };
  if (rank(one) != rank(other)) return rank(one) > rank(other);
  return one.summary.error && other.summary.error &&
         l1(*one.summary.error) < l1(*other.summary.error);
}

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
  const Options used = as_used(options, fine.summary);
  const Result middle = solve(direct(refined(used, 1 / kLevelRatio)));
  const Result coarse = solve(direct(refined(used, 1 / (kLevelRatio * kLevelRatio))));
  if (middle.solution.density && coarse.solution.density) {
    add_estimate(
        fine, middle.solution,
        estimate_error(coarse.solution, middle.solution, fine.solution, order_of(options)));
    judge_error(options, fine);
  }
  return fine;
}

Result solve_within(const SolveOnOneGrid& solve, const Options& options, const Deadline& deadline) {
  return solve_within(solve, options, deadline, Aim{});
}

Result solve_within(const SolveOnOneGrid& solve, const Options& options, const Deadline& deadline,
                    const Aim& aim) {
  double slower = kSlower;
  constexpr double kSoon = 8;  // of the time that is left, its inverse
  const Stopwatch stopwatch;
  Result best = solve_with_error_estimate(solve, options);
  if (!best.summary.error) return best;
  // The three grids together took about 1 + 1/2.5 + 1/6 times as long as the finest.
  double seconds = stopwatch.seconds() / 1.6;
  Options level = direct(as_used(options, best.summary));
  // Of the three last levels the two coarser ones.
  const Options before = refined(level, 1 / kLevelRatio);
  Result middle = best;
  std::optional<Result> coarse;
  // A box that is too small is not mended by cells.
  while (best.solution.status != Status::failed &&
         (l1(*best.summary.error) > aim.accuracy || (aim.until_ok && !best.solution.is_ok()))) {
    // How many levels are missing, by what the last three have shown.
    const double order =
        std::clamp(best.summary.error->observed_order, 0.5, static_cast<double>(order_of(options)));
    const double missing =
        std::max(1.0, std::ceil(std::log(l1(*best.summary.error) / aim.accuracy) /
                                (order * std::log(kLevelRatio))));
    double expected = 0;
    for (int n = 1; n <= missing; ++n) expected += seconds * std::pow(slower, n);
    // Without a hope of that accuracy soon only what is not ok yet is improved.
    const bool hopeful = deadline.allows(kSoon * expected);
    if (!hopeful && (best.solution.is_ok() || !deadline.allows(slower * seconds))) break;
    level = refined(level, kLevelRatio);
    const Stopwatch of_level;
    Result fine = solve(level);
    slower = std::max(kSlower, of_level.seconds() / seconds);
    seconds = of_level.seconds();
    if (!fine.solution.density) break;
    if (!coarse) coarse = solve(before);
    if (!coarse->solution.density) break;
    add_estimate(
        fine, middle.solution,
        estimate_error(coarse->solution, middle.solution, fine.solution, order_of(options)));
    judge_error(options, fine);
    coarse = std::exchange(middle, fine);
    if (better(fine, best)) best = std::move(fine);
  }
  return best;
}

Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options,
                          const Deadline& deadline) {
  constexpr double kFirst = 0.5;          // refinement of the coarsest grid
  constexpr double kOrdersMissing = 1.5;  // when the origin is held to limit the order
  Options level = refined(options, kFirst);
  level.wall_density = std::min(options.wall_density, *options.tolerance / 100);
  std::array<std::optional<Result>, 3> last;  // coarse, middle, fine
  std::optional<Result> estimated;            // the finest before the cells were graded
  const auto stop = [&](const std::string& reason) {
    // Graded grids that have no estimate yet do not replace uniform ones that have.
    const bool newer = last[2] && (last[2]->summary.error || !estimated);
    return given_up(newer ? *last[2] : *estimated, options, reason);
  };
  double seconds = 0, slower = kSlower;  // of the last level; how much longer the next one takes
  while (true) {
    if ((last[2] || estimated) && !deadline.allows(slower * seconds)) {
      return stop(fmt::format("about {:.2g} s, more than max_seconds leaves", slower * seconds));
    }
    const Stopwatch of_level;
    Result result = solve(direct(level));
    slower = std::max(kSlower, seconds > 0 ? of_level.seconds() / seconds : 0);
    seconds = of_level.seconds();
    if (!result.solution.density) {
      return last[2] || estimated ? stop(result.solution.reason) : result;
    }
    std::rotate(last.begin(), last.begin() + 1, last.end());
    last[2] = std::move(result);
    if (last[0]) {
      const auto error =
          estimate_error(last[0]->solution, last[1]->solution, last[2]->solution, options.order);
      add_estimate(*last[2], last[1]->solution, error);
      if (worst(error, last[2]->solution.moments) <= *options.tolerance) {
        if (options.stepper == Stepper::direct) {
          judge_error(options, *last[2]);
          return *last[2];
        }
        level.stepper = options.stepper;
        Result stepped = solve(level);
        if (stepped.solution.density) add_estimate(stepped, last[1]->solution, error);
        judge_error(options, stepped);
        return stepped;
      }
      if (options.transport != Transport::characteristics &&
          error.observed_order < options.order - kOrdersMissing &&
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
