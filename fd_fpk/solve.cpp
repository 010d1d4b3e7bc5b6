#include "fd_fpk/solve.hpp"

#include <fmt/format.h>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/stationary/along_characteristics.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"
#include "fd_fpk/stationary/solve_on_one_grid.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/features.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Number of impulses per decay time above which the density is not computed along characteristics.
constexpr double kMostFrequent = 3000;

// Mean acceleration towards the wall due to impulses of nonzero mean, relative to the acceleration
// of the spring at one standard deviation. If this ratio exceeds 1, the oscillator makes short
// flights between impacts instead of half-cycles, and the height of the flights decreases with the
// energy loss at an impact.
double mean_force_ratio(const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  return -problem.impulses.rate_times_moment(1) /
         problem.system.restoring_force()(linear.displacement_deviation);
}

bool has_short_flights(const problem::Problem& problem) {
  constexpr double kBouncing = 1, kLosses = 0.7;
  return mean_force_ratio(problem) > kBouncing && problem.system.restitution() < kLosses;
}

// Whether characteristics are the first choice at this number of impulses per decay time. The
// thresholds are empirical, from random problems (docs/limits.md).
bool are_characteristics_preferred(const problem::Problem& problem, double per_decay_time) {
  constexpr double kRare = 3, kFrequent = 500;  // impulses per decay time
  constexpr double kStrongLosses = 0.4;
  constexpr double kMaxDeflection = 2;  // static deflection, in standard deviations
  if (!problem::is_paper_oscillator(problem)) return per_decay_time < kRare;
  const auto linear = problem::equivalent_linearisation(problem);
  const bool losses =
      problem.system.restitution() < kStrongLosses &&
      problem::static_deflection(problem) < kMaxDeflection * linear.displacement_deviation;
  return per_decay_time < kRare || (losses && per_decay_time < kFrequent) ||
         has_short_flights(problem);
}

// Whether upwind differences cannot resolve the density, because the density is unbounded or
// because flights between impacts are shorter than a cell.
bool are_characteristics_required(const problem::Problem& problem) {
  constexpr double kStronglyBouncing = 5;
  if (!problem::is_paper_oscillator(problem)) return false;
  return is_unbounded_at_origin(problem) ||
         (has_short_flights(problem) && mean_force_ratio(problem) > kStronglyBouncing);
}

// Whether the options permit the solver to choose finer grids.
bool has_automatic_grid(const Options& options) {
  const Options defaults;
  return options.error_estimate && options.refine_unresolved && !options.nx && !options.nv &&
         options.refinement == defaults.refinement;
}

class Solver {
 public:
  Solver(const problem::Problem& problem, const Options& options)
      : problem_(problem),
        scales_(problem::scales(problem)),
        options_(options),
        deadline_(kDeadlineFraction * options.max_seconds) {}

  Result solve() const {
    if (!can_use_characteristics(options_) ||
        !characteristics_unsupported_reason(problem_).empty()) {
      return solve_with(TransportScheme::upwind);
    }
    if (has_rest_in_contact(problem_, options_) ||
        options_.transport == TransportScheme::characteristics) {
      return solve_with(TransportScheme::characteristics);
    }
    const double per_decay_time = problem::impulses_per_decay_time(problem_, scales_);
    const bool along = are_characteristics_preferred(problem_, per_decay_time);
    if (!has_automatic_grid(options_))
      return solve_with(along ? TransportScheme::characteristics : TransportScheme::upwind);
    if (along && are_characteristics_required(problem_))
      return solve_with(TransportScheme::characteristics);
    // The transport of first choice has half of the time limit; the other half remains for the
    // alternative transport.
    Result first = solve_with(
        along ? TransportScheme::characteristics : TransportScheme::upwind,
        Deadline(options_.tolerance ? deadline_.limit_seconds() : deadline_.limit_seconds() / 2));
    // If upwind differences are the alternative, they must reach a small estimated error, because
    // their error estimate is unreliable for such problems.
    if (first.solution.is_ok() && (along || has_small_error(first))) return first;
    // If the transport of first choice misses the tolerance, the alternative does not meet the
    // tolerance faster.
    if (options_.tolerance && first.solution.density) return first;
    // At this impulse rate characteristics would visit too many cells. A box that the options set
    // is the same for both transports.
    const bool given_box = options_.x1_max || options_.x2_max;
    if (given_box || (!along && per_decay_time > kMostFrequent)) return first;
    Result second =
        solve_with(along ? TransportScheme::upwind : TransportScheme::characteristics, deadline_);
    return is_better(second, first) ? second : first;
  }

 private:
  static bool has_small_error(const Result& result) {
    constexpr double kSmallError = 1e-3;
    const auto& error = result.summary.error;
    return error && error->y_l1 <= kSmallError && error->ydot_l1 <= kSmallError;
  }

  Result solve_with(TransportScheme transport) const { return solve_with(transport, deadline_); }

  Result solve_with(TransportScheme transport, const Deadline& deadline) const {
    Options options = options_;
    options.transport = transport;
    // Characteristics have no adjustable order.
    if (transport == TransportScheme::upwind) {
      options.order = options.order.value_or(automatic_order(problem_));
    }
    const bool family = !problem::is_paper_oscillator(problem_);
    ScalesAndBox scales_and_box{.scales = scales_};
    // All grids share one box and the length scales that set the cell widths. A box with the
    // default wall density truncates the tails due to impulses. The truncated tails contribute a
    // fraction 2e-7 of E[v^2], and a hundred times this fraction of the part of E[v^4] due to the
    // fourth cumulant.
    if (family && transport == TransportScheme::upwind) {
      constexpr double kTails = 1e-2, kTailsOfImpulses = 2e-3;
      options.wall_density *= problem_.impulses.is_present() ? kTailsOfImpulses : kTails;
      scales_and_box.box = stationary_box(problem_, scales_and_box.scales, options, deadline);
    }
    const auto on_one_grid = [&](const Options& grid) {
      return transport == TransportScheme::characteristics
                 ? solve_along_characteristics(problem_, scales_, grid, deadline)
                 : solve_on_one_grid(problem_, scales_and_box, grid, deadline);
    };
    if (options.tolerance) return solve_to_tolerance(on_one_grid, options, deadline);
    if (has_automatic_grid(options)) {
      const RefinementGoal goal = family ? RefinementGoal{.until_ok = true} : RefinementGoal{};
      return refine_until_deadline(on_one_grid, options, deadline, goal);
    }
    if (options.error_estimate) return solve_with_error_estimate(on_one_grid, options);
    return on_one_grid(options);
  }

  const problem::Problem& problem_;
  const problem::MotionScales scales_;
  const Options& options_;
  // Time limit as a fraction of max_seconds. A running solve ends at the next check of its
  // deadline.
  static constexpr double kDeadlineFraction = 0.98;
  Deadline deadline_;
};

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const Stopwatch stopwatch;
  Result result = Solver(problem, options).solve();
  auto& [solution, summary] = result;
  solution.seconds = stopwatch.seconds();
  solution.identity = solution_identity(options);
  if (const auto& error = summary.error) {
    solution.error = {error->y_l1, error->ydot_l1, error->moments};
  }
  solution.metrics = metrics(summary);
  return result;
}

}  // namespace fpkcheck::fd_fpk
