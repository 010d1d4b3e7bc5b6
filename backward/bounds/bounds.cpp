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

constexpr int kWeightExponent = 12;  // exponent m of the weight tau

int thread_count(const BoundsOptions& options) {
  return options.threads.value_or(base::available_processors());
}

double requested_half_width(const FunctionalBounds& bound, const BoundsOptions& options) {
  return std::max(options.absolute_half_width,
                  options.relative_half_width * std::abs(bound.enclosure.midpoint()));
}

bool is_narrow_enough(const FunctionalBounds& bound, const BoundsOptions& options) {
  const double requested = requested_half_width(bound, options);
  return requested > 0 && bound.enclosure.half_width() <= requested;
}

// Reason why the refinement of the spline grids stopped for a functional.
struct RefinementStopReason {
  enum class Cause {
    none,         // the refinement continues, or the bounds have the requested half-width
    time_limit,   // the next grid would end after the time limit
    finest_grid,  // no finer grid exists
    fit_failure   // the fit failed, with the error message below
  };
  Cause cause = Cause::none;
  double expected_seconds = 0;  // expected total computing time at the end of the next grid
  std::string error_message{};
};

// Next spline grid of a functional in its sequence of grids from coarse to fine.
struct NextRefinementGrid {
  std::size_t level = 0;
  bool skips_a_grid = false;    // whether the grid before this grid was not computed
  double expected_seconds = 0;  // expected computing time; 0 for the first grid
};

// State of the refinement of the grids.
struct GridRefinement {
  GuaranteedBounds bounds;
  std::vector<RefinementStopReason> stop_reasons;  // one element for each functional
  std::vector<NextRefinementGrid> next_grids;      // one element for each functional
};

// Returns the grid after the grid `last`. The second spline grid is skipped if the requested
// half-width probably requires the third grid and the time suffices for the third grid. Spline
// grids after the third are not skipped, since each of the finest grids gives the narrowest bounds
// of some functional.
NextRefinementGrid select_next_grid(const NextRefinementGrid& last, double last_seconds,
                                    const FunctionalBounds& bound, const BoundsOptions& options,
                                    double seconds_left) {
  // Ratio of the half-widths of the bounds on successive spline grids, about 2 to 5 in cases 1 to 4
  constexpr double kWidthRatio = 3;
  const double requested = requested_half_width(bound, options);
  const double seconds = kMaxGridTimeRatio * last_seconds;
  const bool skips = last.level == 0 && requested > 0 &&
                     bound.enclosure.half_width() > kWidthRatio * requested &&
                     kMaxGridTimeRatio * seconds <= seconds_left;
  return skips ? NextRefinementGrid{last.level + 2, true, kMaxGridTimeRatio * seconds}
               : NextRefinementGrid{last.level + 1, false, seconds};
}

using FunctionalIndices = std::vector<std::size_t>;

// A spline grid and the functionals whose bounds are computed next on this grid.
struct SplineGridAndFunctionals {
  SplineGrid grid;
  FunctionalIndices functional_indices;
};

// Groups the functionals whose guaranteed bounds are wider than requested. All functionals of a
// group have the same next spline grid. Stores a RefinementStopReason for each functional without a
// further spline grid in its sequence.
std::vector<SplineGridAndFunctionals> group_by_next_grid(const BoundsOptions& options,
                                                         GridRefinement& refinement) {
  std::vector<SplineGridAndFunctionals> groups;
  for (std::size_t i = 0; i < refinement.bounds.functional_bounds.size(); ++i) {
    const FunctionalBounds& bound = refinement.bounds.functional_bounds[i];
    RefinementStopReason& stop_reason = refinement.stop_reasons[i];
    if (stop_reason.cause != RefinementStopReason::Cause::none || is_narrow_enough(bound, options))
      continue;
    const auto grids = spline_grid_sequence(bound_width_limiting_feature(bound.functional));
    const std::size_t level = refinement.next_grids[i].level;
    if (level >= grids.size()) {
      stop_reason.cause = RefinementStopReason::Cause::finest_grid;
      continue;
    }
    const auto same = std::ranges::find(groups, grids[level], &SplineGridAndFunctionals::grid);
    if (same == groups.end()) {
      groups.push_back({grids[level], {i}});
    } else {
      same->functional_indices.push_back(i);
    }
  }
  return groups;
}

double round_up_to_two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

// Returns the functional of the mirrored problem whose value equals, up to the sign, the value of
// the given functional of the original problem.
StationaryFunctional mirror_functional(const StationaryFunctional& functional) {
  if (const SmoothBin* const bin = std::get_if<SmoothBin>(&functional)) {
    SmoothBin other = *bin;
    for (std::size_t i = 0; i < bin->knots.size(); ++i) {
      other.knots[i] = -bin->knots[bin->knots.size() - 1 - i];
    }
    return other;
  }
  return functional;
}

bool is_odd(const StationaryFunctional& functional) {
  const PowerMoment* const mean = std::get_if<PowerMoment>(&functional);
  return mean != nullptr && mean->power % 2 == 1;
}

// Removes the impact momentum from the functionals unless the system has exactly one wall.
std::vector<StationaryFunctional> supported_functionals(
    const problem::System& system, std::vector<StationaryFunctional> functionals) {
  if (system.left_wall().has_value() == system.right_wall().has_value()) {
    std::erase_if(functionals,
                  [](const auto& f) { return std::holds_alternative<ImpactMomentumFlux>(f); });
  }
  return functionals;
}

// Computes guaranteed bounds on finer and finer spline grids, until the bounds of every functional
// have the requested half-width or a stop reason.
GridRefinement refine_grids(const problem::Problem& problem, const BoundsOptions& options) {
  const ResidualWeightFunctionOfEnergy tau = make_residual_weight(problem, kWeightExponent);
  GridRefinement result;
  for (const StationaryFunctional& f : options.functionals) {
    result.bounds.functional_bounds.push_back({f, {-HUGE_VAL, HUGE_VAL}});
  }
  result.stop_reasons.resize(options.functionals.size());
  result.next_grids.resize(options.functionals.size());

  const base::Stopwatch stopwatch;
  for (;;) {
    const auto groups = group_by_next_grid(options, result);
    if (groups.empty()) return result;
    for (const auto& [grid, indices] : groups) {
      double seconds = 0;
      for (const std::size_t i : indices)
        seconds = std::max(seconds, result.next_grids[i].expected_seconds);
      const double expected = stopwatch.seconds() + seconds;
      const auto stop_or_return_to_skipped_grid =
          [&result, &ended = indices](const RefinementStopReason& reason) {
            for (const std::size_t i : ended) {
              NextRefinementGrid& next = result.next_grids[i];
              if (next.skips_a_grid) {
                next = {next.level - 1, false, next.expected_seconds / kMaxGridTimeRatio};
              } else {
                result.stop_reasons[i] = reason;
              }
            }
          };
      if (seconds > 0 && expected > options.time_limit_seconds) {
        stop_or_return_to_skipped_grid({RefinementStopReason::Cause::time_limit, expected});
        continue;
      }
      std::vector<StationaryFunctional> functionals;
      for (const std::size_t i : indices) functionals.push_back(options.functionals[i]);
      const base::Stopwatch grid_stopwatch;
      SplineGridDiagnostics diagnostics;
      BoundsOnSplineGrid grid_bounds{grid, 0, 0, indices, {}};
      try {
        grid_bounds.enclosures = compute_bounds_on_grid(problem, tau, grid, functionals,
                                                        thread_count(options), &diagnostics);
      } catch (const LeastSquaresFitFailure& failure) {
        // The fit would also fail on finer grids.
        stop_or_return_to_skipped_grid(
            {RefinementStopReason::Cause::fit_failure, 0, failure.what()});
        continue;
      }
      grid_bounds.unknown_count = diagnostics.unknown_count;
      grid_bounds.computing_seconds = grid_stopwatch.seconds();
      for (std::size_t n = 0; n < indices.size(); ++n) {
        FunctionalBounds& bound = result.bounds.functional_bounds[indices[n]];
        bound.enclosure = bound.enclosure.intersection(grid_bounds.enclosures[n]);
        // The enclosures of an expectation from two spline grids both contain the exact
        // expectation. If the enclosures of an expectation from two spline grids are disjoint, the
        // program or the rounding of the processor has an error.
        if (bound.enclosure.lower > bound.enclosure.upper) {
          throw std::logic_error("bounds of " + functional_name(functionals[n]) +
                                 " from two grids are disjoint");
        }
        NextRefinementGrid& next = result.next_grids[indices[n]];
        next = select_next_grid(next, grid_bounds.computing_seconds, bound, options,
                                options.time_limit_seconds - stopwatch.seconds());
      }
      result.bounds.grid_bounds.push_back(std::move(grid_bounds));
    }
  }
}

// Computes the bounds of a problem with only a right wall from the mirrored problem.
GridRefinement refine_grids_of_mirrored_problem(const problem::Problem& problem,
                                                const BoundsOptions& options) {
  BoundsOptions mirrored_options = options;
  for (StationaryFunctional& f : mirrored_options.functionals) f = mirror_functional(f);
  GridRefinement result = refine_grids(
      problem::to_wall_coordinates({.origin = 0, .mirrored = true}, problem), mirrored_options);
  const auto restore_sign = [](const StationaryFunctional& f, numerics::Enclosure& value) {
    if (is_odd(f)) value = {-value.upper, -value.lower};
  };
  for (FunctionalBounds& bound : result.bounds.functional_bounds) {
    restore_sign(bound.functional, bound.enclosure);
    bound.functional = mirror_functional(bound.functional);
  }
  for (BoundsOnSplineGrid& grid_bounds : result.bounds.grid_bounds) {
    for (std::size_t n = 0; n < grid_bounds.functional_indices.size(); ++n) {
      restore_sign(result.bounds.functional_bounds[grid_bounds.functional_indices[n]].functional,
                   grid_bounds.enclosures[n]);
    }
  }
  return result;
}

// Returns the names of the functionals whose grid refinement stopped for the given reason.
std::vector<std::string> functionals_stopped_by(RefinementStopReason::Cause cause,
                                                const GridRefinement& refinement) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < refinement.stop_reasons.size(); ++i) {
    if (refinement.stop_reasons[i].cause == cause)
      names.push_back(functional_name(refinement.bounds.functional_bounds[i].functional));
  }
  return names;
}

// Returns a message about bounds that are wider than requested, with the reason and an option that
// the user can change.
std::string unmet_width_reason(const GridRefinement& refinement, const BoundsOptions& options) {
  const auto& reasons = refinement.stop_reasons;
  if (const auto names =
          functionals_stopped_by(RefinementStopReason::Cause::time_limit, refinement);
      !names.empty()) {
    double seconds = 0;
    for (const RefinementStopReason& reason : reasons)
      seconds = std::max(seconds, reason.expected_seconds);
    return fmt::format(
        "guaranteed, but wider than requested: the next grid for {} would end after {:.2g} s; "
        "increase --seconds above {:g}",
        fmt::join(names, ", "), seconds, options.time_limit_seconds);
  }
  if (const auto names =
          functionals_stopped_by(RefinementStopReason::Cause::finest_grid, refinement);
      !names.empty()) {
    double widest = 0, relative = 0;
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      if (reasons[i].cause != RefinementStopReason::Cause::finest_grid) continue;
      const numerics::Enclosure& value = refinement.bounds.functional_bounds[i].enclosure;
      widest = std::max(widest, value.half_width());
      relative = std::max(relative, value.half_width() / std::abs(value.midpoint()));
    }
    return fmt::format(
        "guaranteed, but wider than requested: no finer grid exists for {}; request {}",
        fmt::join(names, ", "),
        options.relative_half_width > 0
            ? fmt::format("--width {:.2g}", round_up_to_two_digits(relative))
            : fmt::format("--absolute-width {:.2g}", round_up_to_two_digits(widest)));
  }
  const auto failure = std::ranges::find(reasons, RefinementStopReason::Cause::fit_failure,
                                         &RefinementStopReason::cause);
  return fmt::format("guaranteed, but wider than requested: {}",
                     failure == reasons.end() ? "" : failure->error_message);
}

}  // namespace

GuaranteedBounds compute_guaranteed_bounds(const problem::Problem& problem,
                                           const BoundsOptions& requested) {
  require_valid_bounds_options(requested);
  GuaranteedBounds refusal;
  refusal.reason = bounds_unsupported_reason(problem);
  if (!refusal.reason.empty()) {
    refusal.status = BoundsStatus::not_offered;
    return refusal;
  }
  BoundsOptions options = requested;
  options.functionals = supported_functionals(problem.system, requested.functionals);
  const bool is_mirrored = problem.system.right_wall() && !problem.system.left_wall();
  GridRefinement refinement = is_mirrored ? refine_grids_of_mirrored_problem(problem, options)
                                          : refine_grids(problem, options);
  GuaranteedBounds& result = refinement.bounds;
  for (std::size_t i = 0; i < result.functional_bounds.size(); ++i) {
    const FunctionalBounds& b = result.functional_bounds[i];
    if (std::isfinite(b.enclosure.half_width())) continue;
    result.status = BoundsStatus::failed;
    result.reason = refinement.stop_reasons[i].cause == RefinementStopReason::Cause::fit_failure
                        ? refinement.stop_reasons[i].error_message
                        : "no finite bounds of " + functional_name(b.functional);
    return result;
  }
  const bool is_width_requested =
      options.absolute_half_width > 0 || options.relative_half_width > 0;
  const bool is_width_met = std::ranges::all_of(
      result.functional_bounds,
      [&](const FunctionalBounds& bound) { return is_narrow_enough(bound, options); });
  if (is_width_requested && !is_width_met) {
    result.status = BoundsStatus::width_not_met;
    result.reason = unmet_width_reason(refinement, options);
  }
  return result;
}

}  // namespace fpkcheck::backward
