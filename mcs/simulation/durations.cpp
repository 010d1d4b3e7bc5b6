#include "mcs/simulation/durations.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::mcs {
namespace {

// All in slowest decay times.
constexpr double kAutomaticTime = 1.6e6;
constexpr double kBurnIn = 20;  // exp(-20) of the start is left
constexpr double kMixed = 5;    // of the burn-in, at least
// L1 error of p(y) or p(y') in 99 runs of 100, times the root of the time: 0.6 to 2.3 in the shipped
// cases without wells to leave and without strong losses (`fpkcheck mcs CASE --json`: sampling_l1 and
// time), up to 4.3 with.
constexpr double kErrorOfOneDecayTime = 2.5;

constexpr double kTailsShare = 1.0 / 32;      // the branches take several times as long
constexpr double kControlledShare = 1.0 / 8;  // L1 noise in smooth bins about 2e-6

// Impulses and flights, in all streams. A processor does 2e7 to 3e7 in a second.
constexpr double kUsualEvents = 4e7;    // of any oscillator: seconds
constexpr double kMostRunEvents = 2e9;  // a minute
// Of the trunk of the splitting, whose branches are up to 17 times as many and fly faster, in lanes
// of which half are idle: half a minute (`fpkcheck_random --tails --family --count 40`).
constexpr double kMostTrunkEvents = 2.5e6;

constexpr double kMostAutomaticTimes = 1e4;  // where samples or an error are asked for
constexpr double kLongestBurnIn = 1.0 / 8;   // of the automatic time

double automatic_time(const Options& options, const Pace& pace) {
  const double share = options.tails ? kTailsShare : options.controlled ? kControlledShare : 1;
  const double full = kAutomaticTime * share / pace.decay;
  const double most = (options.tails ? kMostTrunkEvents : kMostRunEvents) / pace.events();
  const double usual =
      pace.any_oscillator ? kUsualEvents * (options.tails ? kTailsShare : 1) / pace.events() : most;
  const double enough = std::pow(kErrorOfOneDecayTime / options.accuracy, 2) / pace.decay;
  // More than the full time nobody waits for.
  const bool in_vain = enough > full || (enough > most && pace.wells > 1);
  return std::min(full, in_vain ? usual : std::max(usual, std::min(enough, most)));
}

double burn_in(const Options& options, const Pace& pace, double automatic, double time) {
  return std::min(kBurnIn / pace.decay,
                  std::max(kLongestBurnIn * automatic, time) / options.streams);
}

}  // namespace

Durations durations_of(const Options& options, const Pace& pace) {
  const double automatic = automatic_time(options, pace);
  const bool open_ended = options.samples || options.target_error;
  const double time = options.time.value_or(automatic * (open_ended ? kMostAutomaticTimes : 1));
  Durations durations{.automatic = automatic,
                      .time = time,
                      .burn_in = burn_in(options, pace, automatic, time),
                      .burn_in_limit = BurnInLimit::none};
  const auto is_mixed = [&](double taken) { return taken * pace.decay >= kMixed; };
  if (is_mixed(durations.burn_in)) return durations;
  Pace without = pace;
  without.impulses = 0;
  const double of_motion = automatic_time(options, without);
  durations.burn_in_limit =
      is_mixed(burn_in(options, without, of_motion, options.time.value_or(of_motion)))
          ? BurnInLimit::impulses
      : pace.wells > 1 ? BurnInLimit::wells
                       : BurnInLimit::decay;
  return durations;
}

}  // namespace fpkcheck::mcs
