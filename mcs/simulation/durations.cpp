#include "mcs/simulation/durations.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::mcs {
namespace {

// Times in units of the decay time of the slowest mode.
constexpr double kAutomaticTime = 1.6e6;
constexpr double kBurnIn = 20;      // leaves exp(-20) of the initial deviation
constexpr double kLeastBurnIn = 5;  // least burn-in of a converged solution
// 99 % quantile of the L1 sampling error of p(y) or p(y'), times the square root of the simulated
// time in decay times. This product is 0.6 to 2.3 in the shipped cases with a single well and
// without strong losses, and up to 4.3 in the other cases (`fpkcheck mcs CASE --json`: sampling_l1
// and time).
constexpr double kErrorOfOneDecayTime = 2.5;

constexpr double kTailsShare = 1.0 / 32;      // splitting makes the work several times larger
constexpr double kControlledShare = 1.0 / 8;  // L1 error in smooth bins about 2e-6

// Numbers of impulses and flights in all streams. One processor simulates 2e7 to 3e7 per second.
constexpr double kDefaultEvents = 4e7;  // other flights than DuffingFlights: some seconds
constexpr double kMostRunEvents = 2e9;  // one minute
// Number of impulses and flights of the main branches with splitting, simulated in half a minute
// (`fpkcheck_random --tails --family --count 40`). There are up to 17 times as many other branches.
// These branches have more flights per unit time and leave half of the SIMD lanes idle.
constexpr double kMostTrunkEvents = 2.5e6;

constexpr double kMostAutomaticTimes = 1e4;  // with Options::samples or Options::target_error
constexpr double kLongestBurnIn = 1.0 / 8;   // fraction of the default time

double automatic_time(const Options& options, const EventRates& rates) {
  const double share = options.tails ? kTailsShare : options.controlled ? kControlledShare : 1;
  const double full = kAutomaticTime * share / rates.decay;
  const double most = (options.tails ? kMostTrunkEvents : kMostRunEvents) / rates.total_rate();
  const double default_time =
      rates.duffing_flights
          ? most
          : kDefaultEvents * (options.tails ? kTailsShare : 1) / rates.total_rate();
  const double enough = std::pow(kErrorOfOneDecayTime / options.accuracy, 2) / rates.decay;
  // Options::accuracy cannot be reached within the full time, or within a minute with several
  // wells.
  const bool is_out_of_reach = enough > full || (enough > most && rates.wells > 1);
  return std::min(full,
                  is_out_of_reach ? default_time : std::max(default_time, std::min(enough, most)));
}

double burn_in(const Options& options, const EventRates& rates, double automatic, double time) {
  return std::min(kBurnIn / rates.decay,
                  std::max(kLongestBurnIn * automatic, time) / options.streams);
}

}  // namespace

Durations choose_durations(const Options& options, const EventRates& rates) {
  const double automatic = automatic_time(options, rates);
  const bool open_ended = options.samples || options.target_error;
  const double time = options.time.value_or(automatic * (open_ended ? kMostAutomaticTimes : 1));
  Durations durations{.automatic = automatic,
                      .time = time,
                      .burn_in = burn_in(options, rates, automatic, time),
                      .short_burn_in_cause = ShortBurnInCause::none};
  const auto is_long_enough = [&](double taken) { return taken * rates.decay >= kLeastBurnIn; };
  if (is_long_enough(durations.burn_in)) return durations;
  EventRates without = rates;
  without.impulses = 0;
  const double of_motion = automatic_time(options, without);
  durations.short_burn_in_cause =
      is_long_enough(burn_in(options, without, of_motion, options.time.value_or(of_motion)))
          ? ShortBurnInCause::impulses
      : rates.wells > 1 ? ShortBurnInCause::wells
                        : ShortBurnInCause::decay;
  return durations;
}

}  // namespace fpkcheck::mcs
