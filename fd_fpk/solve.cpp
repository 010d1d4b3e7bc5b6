#include "fd_fpk/solve.hpp"

#include <fmt/format.h>

#include "fd_fpk/offered.hpp"
#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/stationary/along_characteristics.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"
#include "fd_fpk/stationary/one_grid.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/features.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Impulses per decay time above which characteristics are not computed.
constexpr double kMostFrequent = 3000;

// Mean acceleration towards the wall due to impulses of nonzero mean, relative to the acceleration
// of the spring at one standard deviation. Above 1 the oscillator makes short flights between
// impacts instead of half-cycles, and their height decreases with the energy loss of an impact.
double pressing(const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  return -problem.impulses.rate_moment(1) / problem.system.force()(linear.displacement_deviation);
}

bool bounces(const problem::Problem& problem) {
  constexpr double kPressed = 1, kLosses = 0.7;
  return pressing(problem) > kPressed && problem.system.restitution() < kLosses;
}

// True where characteristics are the first choice at this number of impulses per decay time. The
// thresholds are empirical, from random problems (docs/limits.md).
bool prefer_characteristics(const problem::Problem& problem, double per_decay_time) {
  constexpr double kRare = 3, kFrequent = 500;  // impulses per decay time
  constexpr double kStrongLosses = 0.4;
  constexpr double kOffTheWall = 2;  // static deflection, in standard deviations
  if (!problem::of_the_paper(problem)) return per_decay_time < kRare;
  const auto linear = problem::equivalent_linearisation(problem);
  const bool losses =
      problem.system.restitution() < kStrongLosses &&
      problem::static_deflection(problem) < kOffTheWall * linear.displacement_deviation;
  return per_decay_time < kRare || (losses && per_decay_time < kFrequent) || bounces(problem);
}

// True where upwind differences cannot resolve the density: an unbounded density, or flights
// between impacts that are shorter than a cell.
bool need_characteristics(const problem::Problem& problem) {
  constexpr double kPressedDown = 5;
  if (!problem::of_the_paper(problem)) return false;
  return unbounded_at_origin(problem) || (bounces(problem) && pressing(problem) > kPressedDown);
}

// True where the solver may choose finer grids than those of the options.
bool grid_is_free(const Options& options) {
  const Options usual;
  return options.error_estimate && options.refine_unresolved && !options.nx && !options.nv &&
         options.refinement == usual.refinement;
}

class Solver {
 public:
  Solver(const problem::Problem& problem, const Options& options)
      : problem_(problem),
        scales_(problem::scales(problem)),
        options_(options),
        deadline_(kUntilTheEnd * options.max_seconds) {}

  Result solve() const {
    if (!may_follow_characteristics(options_) || !characteristics_objection(problem_).empty()) {
      return by(Transport::upwind);
    }
    if (rests_in_contact(problem_, options_) || options_.transport == Transport::characteristics) {
      return by(Transport::characteristics);
    }
    const double per_decay_time = problem::impulses_per_decay_time(problem_, scales_);
    const bool along = prefer_characteristics(problem_, per_decay_time);
    if (!grid_is_free(options_)) return by(along ? Transport::characteristics : Transport::upwind);
    if (along && need_characteristics(problem_)) return by(Transport::characteristics);
    // The first choice has half of the time, which leaves the second half for the alternative.
    Result first = by(along ? Transport::characteristics : Transport::upwind,
                      Deadline(options_.tolerance ? deadline_.in_all() : deadline_.in_all() / 2));
    // Differences that are not the first choice need a small error: their error estimate is
    // unreliable there.
    if (first.solution.is_ok() && (along || good(first))) return first;
    // A tolerance that the first choice misses cannot be met faster with the alternative.
    if (options_.tolerance && first.solution.density) return first;
    // Characteristics would visit too many cells at this impulse rate. A box that the options set
    // is the same for both transports.
    const bool given_box = options_.x1_max || options_.x2_max;
    if (given_box || (!along && per_decay_time > kMostFrequent)) return first;
    Result second = by(along ? Transport::upwind : Transport::characteristics, deadline_);
    return better(second, first) ? second : first;
  }

 private:
  static bool good(const Result& result) {
    constexpr double kGood = 1e-3;
    const auto& error = result.summary.error;
    return error && error->y_l1 <= kGood && error->ydot_l1 <= kGood;
  }

  Result by(Transport transport) const { return by(transport, deadline_); }

  Result by(Transport transport, const Deadline& deadline) const {
    Options options = options_;
    options.transport = transport;
    // Characteristics have no adjustable order.
    if (transport == Transport::upwind) {
      options.order = options.order.value_or(automatic_order(problem_));
    }
    const bool family = !problem::of_the_paper(problem_);
    Surroundings surroundings{.scales = scales_};
    // All grids share the box and the length scales that set the cell widths. A box of the default
    // wall density truncates the tails due to impulses: 2e-7 of E[v^2], and a hundred times this
    // fraction of the excess of E[v^4] due to the fourth cumulant.
    if (family && transport == Transport::upwind) {
      constexpr double kTails = 1e-2, kTailsOfImpulses = 2e-3;
      options.wall_density *= problem_.impulses.present() ? kTailsOfImpulses : kTails;
      surroundings.box = stationary_box(problem_, surroundings.scales, options, deadline);
    }
    const auto on_one_grid = [&](const Options& grid) {
      return transport == Transport::characteristics
                 ? solve_along_characteristics(problem_, scales_, grid, deadline)
                 : solve_on_one_grid(problem_, surroundings, grid, deadline);
    };
    if (options.tolerance) return solve_to_tolerance(on_one_grid, options, deadline);
    if (grid_is_free(options)) {
      const Aim aim = family ? Aim{.until_ok = true} : Aim{};
      return solve_within(on_one_grid, options, deadline, aim);
    }
    if (options.error_estimate) return solve_with_error_estimate(on_one_grid, options);
    return on_one_grid(options);
  }

  const problem::Problem& problem_;
  const problem::Scales scales_;
  const Options& options_;
  // Fraction of max_seconds; a running solve ends when it next checks its deadline.
  static constexpr double kUntilTheEnd = 0.98;
  Deadline deadline_;
};

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const Stopwatch stopwatch;
  Result result = Solver(problem, options).solve();
  auto& [solution, summary] = result;
  solution.seconds = stopwatch.seconds();
  solution.identity = identity(options);
  if (const auto& error = summary.error) {
    solution.error = {error->y_l1, error->ydot_l1, error->moments};
  }
  solution.observations = observations(summary);
  return result;
}

}  // namespace fpkcheck::fd_fpk
