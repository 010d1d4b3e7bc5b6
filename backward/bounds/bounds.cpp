#include "backward/bounds/bounds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backward/bounds/bounds_from_grid.hpp"
#include "backward/generator/normal_equations.hpp"
#include "base/input_error.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kWeightPower = 12;

int threads_of(const Options& options) {
  return options.threads.value_or(base::available_processors());
}

double requested_half_width(const FunctionalBounds& bound, const Options& options) {
  return std::max(options.half_width, options.relative_half_width * std::abs(bound.value.middle()));
}

bool is_narrow_enough(const FunctionalBounds& bound, const Options& options) {
  const double requested = requested_half_width(bound, options);
  return requested > 0 && bound.value.half_width() <= requested;
}

// Reason why the refinement of the grids stopped for a functional.
struct StopReason {
  enum class Cause { none, time, grids, fit } cause = Cause::none;
  double seconds = 0;  ///< expected total computing time at the end of the next grid
  std::string error_message{};
};

// The next grid of a functional in its sequence of grids.
struct NextGrid {
  std::size_t level = 0;
  bool skips_a_grid = false;
  double seconds = 0;  ///< expected computing time; 0 for the first grid
};

struct Refinement {
  GuaranteedBounds bounds;
  std::vector<StopReason> ends;  ///< reason why the refinement stopped, for each functional
  std::vector<NextGrid> next;    ///< next grid of each functional
};

// Returns the grid after `last`. The second grid is skipped if the requested half-width probably
// needs the third, and the time suffices. Of the finest grids each has the narrowest bounds of some
// functional.
NextGrid grid_after(const NextGrid& last, double seconds_of_last, const FunctionalBounds& bound,
                    const Options& options, double seconds_left) {
  constexpr double kWidthRatio = 3;  // between successive grids; 2 to 5 in the cases of the paper
  const double requested = requested_half_width(bound, options);
  const double seconds = kGridCostRatio * seconds_of_last;
  const bool skips = last.level == 0 && requested > 0 &&
                     bound.value.half_width() > kWidthRatio * requested &&
                     kGridCostRatio * seconds <= seconds_left;
  return skips ? NextGrid{last.level + 2, true, kGridCostRatio * seconds}
               : NextGrid{last.level + 1, false, seconds};
}

using FunctionalIndices = std::vector<std::size_t>;

// A spline grid and the functionals whose bounds are computed next on the grid.
struct GridGroup {
  SplineGrid grid;
  FunctionalIndices indices;
};

// Groups the functionals whose bounds are too wide. All functionals of a group have the same next
// grid. Stores a StopReason for each functional whose grid sequence is exhausted.
std::vector<GridGroup> next_grid_groups(const Options& options, Refinement& refinement) {
  std::vector<GridGroup> groups;
  for (std::size_t i = 0; i < refinement.bounds.each.size(); ++i) {
    const FunctionalBounds& bound = refinement.bounds.each[i];
    StopReason& end = refinement.ends[i];
    if (end.cause != StopReason::Cause::none || is_narrow_enough(bound, options)) continue;
    const auto grids = spline_grid_sequence(width_limiting_feature(bound.functional));
    const std::size_t level = refinement.next[i].level;
    if (level >= grids.size()) {
      end.cause = StopReason::Cause::grids;
      continue;
    }
    const auto same = std::ranges::find(groups, grids[level], &GridGroup::grid);
    if (same == groups.end()) {
      groups.push_back({grids[level], {i}});
    } else {
      same->indices.push_back(i);
    }
  }
  return groups;
}

double round_up_to_two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

// Returns the functional of the mirrored problem whose expectation equals, up to the sign, the
// expectation of the given functional.
Functional mirrored(const Functional& functional) {
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    SmoothBin other = *bin;
    for (std::size_t i = 0; i < bin->knots.size(); ++i) {
      other.knots[i] = -bin->knots[bin->knots.size() - 1 - i];
    }
    return other;
  }
  return functional;
}

bool is_odd(const Functional& functional) {
  const PowerMoment* const mean = std::get_if<PowerMoment>(&functional);
  return mean != nullptr && mean->power % 2 == 1;
}

// Removes the impact momentum unless the system has exactly one wall.
std::vector<Functional> supported_functionals(const problem::System& system,
                                              std::vector<Functional> functionals) {
  if (system.left_wall().has_value() == system.right_wall().has_value()) {
    std::erase_if(functionals,
                  [](const auto& f) { return std::holds_alternative<ImpactMomentum>(f); });
  }
  return functionals;
}

Refinement refinement(const problem::Problem& problem, const Options& options) {
  const ResidualWeight tau = residual_weight(problem, kWeightPower);
  Refinement result;
  for (const Functional& f : options.functionals) {
    result.bounds.each.push_back({f, {-HUGE_VAL, HUGE_VAL}});
  }
  result.ends.resize(options.functionals.size());
  result.next.resize(options.functionals.size());

  const base::Stopwatch stopwatch;
  for (;;) {
    const auto groups = next_grid_groups(options, result);
    if (groups.empty()) return result;
    for (const auto& [grid, indices] : groups) {
      double seconds = 0;
      for (const std::size_t i : indices) seconds = std::max(seconds, result.next[i].seconds);
      const double expected = stopwatch.seconds() + seconds;
      const auto end_or_return_to_skipped_grid = [&result,
                                                  &ended = indices](const StopReason& end) {
        for (const std::size_t i : ended) {
          NextGrid& next = result.next[i];
          if (next.skips_a_grid) {
            next = {next.level - 1, false, next.seconds / kGridCostRatio};
          } else {
            result.ends[i] = end;
          }
        }
      };
      if (seconds > 0 && expected > options.seconds) {
        end_or_return_to_skipped_grid({StopReason::Cause::time, expected});
        continue;
      }
      std::vector<Functional> functionals;
      for (const std::size_t i : indices) functionals.push_back(options.functionals[i]);
      const base::Stopwatch of_grid;
      SplineGridReport report;
      SplineGridBounds record{grid, 0, 0, indices, {}};
      try {
        record.values =
            bounds_from_grid(problem, tau, grid, functionals, threads_of(options), &report);
      } catch (const FitFailure& broken) {
        // the fit would also fail on finer grids
        end_or_return_to_skipped_grid({StopReason::Cause::fit, 0, broken.what()});
        continue;
      }
      record.unknowns = report.unknowns;
      record.seconds = of_grid.seconds();
      for (std::size_t n = 0; n < indices.size(); ++n) {
        FunctionalBounds& bound = result.bounds.each[indices[n]];
        bound.value = bound.value.intersection(record.values[n]);
        // The enclosures from two grids both contain the exact expectation. An empty intersection
        // of the enclosures shows an error of the program or of the rounding of the processor.
        if (bound.value.lower > bound.value.upper) {
          throw std::logic_error("bounds of " + name(functionals[n]) +
                                 " from two grids are disjoint");
        }
        NextGrid& next = result.next[indices[n]];
        next =
            grid_after(next, record.seconds, bound, options, options.seconds - stopwatch.seconds());
      }
      result.bounds.grids.push_back(std::move(record));
    }
  }
}

// Computes the bounds of a problem with only a right wall from the mirrored problem, whose only
// wall is on the left.
Refinement mirrored_refinement(const problem::Problem& problem, const Options& options) {
  Options there = options;
  for (Functional& f : there.functionals) f = mirrored(f);
  Refinement result =
      refinement(problem::to_wall_coordinates({.origin = 0, .mirrored = true}, problem), there);
  const auto turn = [](const Functional& f, numerics::Enclosure& value) {
    if (is_odd(f)) value = {-value.upper, -value.lower};
  };
  for (FunctionalBounds& bound : result.bounds.each) {
    turn(bound.functional, bound.value);
    bound.functional = mirrored(bound.functional);
  }
  for (SplineGridBounds& record : result.bounds.grids) {
    for (std::size_t n = 0; n < record.each.size(); ++n) {
      turn(result.bounds.each[record.each[n]].functional, record.values[n]);
    }
  }
  return result;
}

// Returns the names of the functionals whose refinement stopped by the given cause.
std::vector<std::string> functionals_stopped_by(StopReason::Cause cause,
                                                const Refinement& refinement) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < refinement.ends.size(); ++i) {
    if (refinement.ends[i].cause == cause)
      names.push_back(name(refinement.bounds.each[i].functional));
  }
  return names;
}

// Returns a message about bounds that are wider than requested, with the cause and an option that
// the caller can change.
std::string width_reason(const Refinement& refinement, const Options& options) {
  const auto& ends = refinement.ends;
  if (const auto names = functionals_stopped_by(StopReason::Cause::time, refinement);
      !names.empty()) {
    double seconds = 0;
    for (const StopReason& end : ends) seconds = std::max(seconds, end.seconds);
    return fmt::format(
        "guaranteed, but wider than requested: the next grid for {} would end after {:.2g} s; "
        "increase --seconds above {:g}",
        fmt::join(names, ", "), seconds, options.seconds);
  }
  if (const auto names = functionals_stopped_by(StopReason::Cause::grids, refinement);
      !names.empty()) {
    double widest = 0, relative = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].cause != StopReason::Cause::grids) continue;
      const numerics::Enclosure& value = refinement.bounds.each[i].value;
      widest = std::max(widest, value.half_width());
      relative = std::max(relative, value.half_width() / std::abs(value.middle()));
    }
    return fmt::format(
        "guaranteed, but wider than requested: no finer grid exists for {}; request {}",
        fmt::join(names, ", "),
        options.relative_half_width > 0
            ? fmt::format("--width {:.2g}", round_up_to_two_digits(relative))
            : fmt::format("--absolute-width {:.2g}", round_up_to_two_digits(widest)));
  }
  const auto broken = std::ranges::find(ends, StopReason::Cause::fit, &StopReason::cause);
  return fmt::format("guaranteed, but wider than requested: {}",
                     broken == ends.end() ? "" : broken->error_message);
}

}  // namespace

GuaranteedBounds compute_bounds(const problem::Problem& problem, const Options& requested) {
  validate(requested);
  GuaranteedBounds refusal;
  refusal.reason = bounds_unsupported_reason(problem);
  if (!refusal.reason.empty()) {
    refusal.status = BoundsStatus::not_offered;
    return refusal;
  }
  Options options = requested;
  options.functionals = supported_functionals(problem.system, requested.functionals);
  const bool by_mirror = problem.system.right_wall() && !problem.system.left_wall();
  Refinement found =
      by_mirror ? mirrored_refinement(problem, options) : refinement(problem, options);
  GuaranteedBounds& result = found.bounds;
  for (std::size_t i = 0; i < result.each.size(); ++i) {
    const FunctionalBounds& b = result.each[i];
    if (std::isfinite(b.value.half_width())) continue;
    result.status = BoundsStatus::failed;
    result.reason = found.ends[i].cause == StopReason::Cause::fit
                        ? found.ends[i].error_message
                        : "no finite bounds of " + name(b.functional);
    return result;
  }
  const bool is_width_requested = options.half_width > 0 || options.relative_half_width > 0;
  const bool is_width_met = std::ranges::all_of(
      result.each, [&](const FunctionalBounds& bound) { return is_narrow_enough(bound, options); });
  if (is_width_requested && !is_width_met) {
    result.status = BoundsStatus::width_not_met;
    result.reason = width_reason(found, options);
  }
  return result;
}

}  // namespace fpkcheck::backward
