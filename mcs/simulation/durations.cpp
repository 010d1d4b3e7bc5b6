#include "mcs/simulation/durations.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::mcs {
namespace {

// In decay times of the slowest mode.
constexpr double kAutomaticTime = 1.6e6;
constexpr double kBurnIn = 20;  // leaves exp(-20) of the initial deviation
constexpr double kMixed = 5;    // least burn-in of a converged solution
// 99 % quantile of the L1 error of p(y) or p(y'), times the root of the time. It is 0.6 to 2.3 in
// the shipped cases without several wells and without strong losses, and up to 4.3 in the others
// (`fpkcheck mcs CASE --json`: sampling_l1 and time).
constexpr double kErrorOfOneDecayTime = 2.5;

constexpr double kTailsShare = 1.0 / 32;      // branches take several times as long
constexpr double kControlledShare = 1.0 / 8;  // L1 sampling error in smooth bins about 2e-6

// Impulses and flights in all streams. One processor simulates 2e7 to 3e7 per second.
constexpr double kUsualEvents = 4e7;    // any oscillator: some seconds
constexpr double kMostRunEvents = 2e9;  // one minute
// Of the main branches under splitting: half a minute (`fpkcheck_random --tails --family --count
// 40`). The other branches are up to 17 times as many, have more flights per unit time, and leave
// half of the SIMD lanes idle.
constexpr double kMostTrunkEvents = 2.5e6;

constexpr double kMostAutomaticTimes = 1e4;  // with Options::samples or Options::target_error
constexpr double kLongestBurnIn = 1.0 / 8;   // of the default time

double automatic_time(const Options& options, const Pace& pace) {
  const double share = options.tails ? kTailsShare : options.controlled ? kControlledShare : 1;
  const double full = kAutomaticTime * share / pace.decay;
  const double most = (options.tails ? kMostTrunkEvents : kMostRunEvents) / pace.events();
  const double usual =
      pace.any_oscillator ? kUsualEvents * (options.tails ? kTailsShare : 1) / pace.events() : most;
  const double enough = std::pow(kErrorOfOneDecayTime / options.accuracy, 2) / pace.decay;
  // Options::accuracy is out of reach within the full time, or within a minute with several wells.
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
