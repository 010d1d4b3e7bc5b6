#pragma once

#include "mcs/elementary.hpp"
#include "mcs/impulse_source.hpp"
#include "mcs/lanes.hpp"

// Compiled for different instructions, as advance_lanes.hpp.
namespace fpkcheck::mcs {
namespace {

constexpr int kWide = 8;
using Wide = LanesOf<kWide>::Real;

/// Standard amplitudes: mean 0, width 1.
FPKCHECK_INLINE Wide standard_amplitude(Excitation::Law law, const Wide& u, const Wide& w) {
  using Law = Excitation::Law;
  const Wide centred = 2.0 * w - 1.0;
  switch (law) {
    case Law::gaussian:
      // Box and Muller: the cosine of a random angle is the sine of one within a quarter turn.
      return square_root(-2.0 * logarithm(u)) * sine_of_quarter_turns(centred);
    case Law::laplace: {
      const Wide size = -logarithm(u);
      return select(centred < 0.0, -size, size);
    }
    case Law::two_point:
      return select(centred < 0.0, all_lanes<Wide>(-1.0), all_lanes<Wide>(1.0));
    case Law::uniform:
      break;
  }
  return 2.0 * u - 1.0;
}

/// Waiting times and amplitudes of a block of impulses.
FPKCHECK_INLINE void impulses_in_lanes(const Excitation& excitation, const Uniforms& u,
                                       double* waiting, double* amplitude) {
  for (int k = 0; k < ImpulseSource::kBlock; k += kWide) {
    const bool poisson = excitation.arrivals == Excitation::Arrivals::poisson;
    const Wide wait = poisson ? -logarithm(load<Wide>(&u.first[k])) * excitation.interval
                              : all_lanes<Wide>(excitation.interval);
    const Wide standard =
        standard_amplitude(excitation.law, load<Wide>(&u.second[k]), load<Wide>(&u.third[k]));
    store<Wide>(wait, waiting + k);
    store<Wide>(excitation.mean + excitation.width * standard, amplitude + k);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
