#pragma once

#include <type_traits>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/impulses/standard_amplitude.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kLaneCount = 8;
using Real8 = simd::SimdVectorTypes<kLaneCount>::Real;

template <class Law>
FPKCHECK_INLINE void draw_amplitudes(const ImpulseProcess& excitation,
                                     const UniformRandomNumbers& u, ImpulseBlock& block) {
  if constexpr (std::is_base_of_v<AmplitudeByQuantileFunction, StandardAmplitude<Law>>) {
    for (std::size_t k = 0; k < kImpulsesPerBlock; ++k) {
      block.amplitude[k] = excitation.mean + excitation.width * (*excitation.pieces)(u.second[k]);
    }
    return;
  } else {
    for (int k = 0; k < kImpulsesPerBlock; k += kLaneCount) {
      const Real8 standard = StandardAmplitude<Law>::draw_standard_amplitude(
          simd::load<Real8>(&u.second[k]), simd::load<Real8>(&u.third[k]));
      simd::store<Real8>(excitation.mean + excitation.width * standard, &block.amplitude[k]);
    }
  }
}

template <class... Laws>
FPKCHECK_INLINE void draw_amplitudes_of_law(AmplitudeLawList<Laws...>,
                                            const ImpulseProcess& excitation,
                                            const UniformRandomNumbers& u, ImpulseBlock& block) {
  int index = 0;
  ((index++ == excitation.law ? draw_amplitudes<Laws>(excitation, u, block) : void()), ...);
}

FPKCHECK_INLINE ImpulseBlock draw_impulse_block(const ImpulseProcess& excitation,
                                                const UniformRandomNumbers& u) {
  ImpulseBlock block;
  const bool poisson = excitation.arrivals == ImpulseProcess::Arrivals::poisson;
  for (int k = 0; k < kImpulsesPerBlock; k += kLaneCount) {
    const Real8 wait = poisson
                           ? -simd::logarithm(simd::load<Real8>(&u.first[k])) * excitation.interval
                           : simd::all_lanes_equal_to<Real8>(excitation.interval);
    simd::store<Real8>(wait, &block.waiting_time[k]);
  }
  draw_amplitudes_of_law(AmplitudeLaws(), excitation, u, block);
  return block;
}

}  // namespace
}  // namespace fpkcheck::mcs
