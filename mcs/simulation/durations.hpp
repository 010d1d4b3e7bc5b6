#pragma once

#include "mcs/options.hpp"

namespace fpkcheck::mcs {

/// How fast a problem forgets and how much there is to compute, per unit time.
struct Pace {
  double decay;     ///< of the slowest deviation
  double impulses;  ///< or the kicks of white noise in their place
  double flights;   ///< and kicks of noise beside impulses
  bool any_oscillator = false;
  int wells = 1;

  double events() const { return impulses + flights; }
};

/// Why a burn-in is below 5 decay times.
enum class BurnInLimit {
  none,      ///< it is not: exp(-5) of the start is left, or less
  impulses,  ///< frequent impulses
  wells,     ///< that are rarely left
  decay      ///< little damping
};

struct Durations {
  double automatic;  ///< simulated time over all streams where nobody asks for another
  double time;       ///< what is simulated at most
  double burn_in;    ///< of each stream
  BurnInLimit burn_in_limit;
};

/// The automatic time is 1.6e6 decay times (L1 errors of p(y) and p(y') by chance about 6e-4), shared
/// as Options::time says, where the simulation then takes some seconds (beyond the paper's class) or a
/// minute (in the class). Elsewhere it is the time for those seconds, or the longer time that
/// Options::accuracy needs, for a minute at most. Wells that are rarely left get the seconds alone: a
/// minute would not find their masses.
Durations durations_of(const Options& options, const Pace& pace);

}  // namespace fpkcheck::mcs
