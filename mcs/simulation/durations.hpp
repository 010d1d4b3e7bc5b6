#pragma once

#include "mcs/options.hpp"

namespace fpkcheck::mcs {

/// Decay rate and event rates of a problem, per unit time.
struct EventRates {
  double decay;     ///< rate of the slowest mode
  double impulses;  ///< rate of impulses, or of the kicks of white noise that replace impulses
  double flights;   ///< rate of flights, plus that of noise kicks that act besides impulses
  /// Whether the flights are DuffingFlights, which are simulated about twice as fast as others.
  bool duffing_flights = true;
  int wells = 1;

  double total_rate() const { return impulses + flights; }
};

/// Cause of a burn-in below 5 decay times.
enum class ShortBurnInCause {
  none,      ///< the burn-in leaves exp(-5) of the initial deviation, or less
  impulses,  ///< frequent impulses
  wells,     ///< rare transitions between wells
  decay      ///< weak damping
};

struct Durations {
  double automatic;  ///< default simulated time over all streams
  double time;       ///< upper limit of the simulated time
  double burn_in;    ///< duration of the burn-in of each stream
  ShortBurnInCause short_burn_in_cause;
};

/// Chooses the simulated time and the burn-in. The full simulated time is 1.6e6 decay times,
/// reduced as in Options::time; the L1 sampling errors of p(y) and p(y') are then about 6e-4. The
/// full time is the default if its simulation takes at most a minute with DuffingFlights, or some
/// seconds with other flights. Otherwise the default time is shorter: its simulation takes
/// some seconds, or up to a minute if Options::accuracy needs more. With several wells and rare
/// transitions the simulation takes some seconds only, since even a minute would not determine the
/// masses of the wells.
Durations choose_durations(const Options& options, const EventRates& rates);

}  // namespace fpkcheck::mcs
