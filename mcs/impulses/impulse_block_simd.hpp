#pragma once

#include <type_traits>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/impulses/standard_amplitude.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kLaneCount = 8;
using Real8 = simd::VectorTypes<kLaneCount>::Real;

template <class Law>
FPKCHECK_INLINE void draw_amplitudes(const Excitation& excitation, const UniformNumbers& u,
                                     ImpulseBlock& block) {
  if constexpr (std::is_base_of_v<DrawnFromQuantileFunction, StandardAmplitude<Law>>) {
    for (std::size_t k = 0; k < kBlockSize; ++k) {
      block.amplitude[k] = excitation.mean + excitation.width * (*excitation.pieces)(u.second[k]);
    }
    return;
  } else {
    for (int k = 0; k < kBlockSize; k += kLaneCount) {
      const Real8 standard = StandardAmplitude<Law>::draw(simd::load<Real8>(&u.second[k]),
                                                          simd::load<Real8>(&u.third[k]));
      simd::store<Real8>(excitation.mean + excitation.width * standard, &block.amplitude[k]);
    }
  }
}

template <class... Laws>
FPKCHECK_INLINE void draw_amplitudes_of_law(LawList<Laws...>, const Excitation& excitation,
                                            const UniformNumbers& u, ImpulseBlock& block) {
  int index = 0;
  ((index++ == excitation.law ? draw_amplitudes<Laws>(excitation, u, block) : void()), ...);
}

FPKCHECK_INLINE ImpulseBlock draw_impulse_block(const Excitation& excitation,
                                                const UniformNumbers& u) {
  ImpulseBlock block;
  const bool poisson = excitation.arrivals == Excitation::Arrivals::poisson;
  for (int k = 0; k < kBlockSize; k += kLaneCount) {
    const Real8 wait = poisson
                           ? -simd::logarithm(simd::load<Real8>(&u.first[k])) * excitation.interval
                           : simd::broadcast<Real8>(excitation.interval);
    simd::store<Real8>(wait, &block.waiting[k]);
  }
  draw_amplitudes_of_law(AmplitudeLaws(), excitation, u, block);
  return block;
}

}  // namespace
}  // namespace fpkcheck::mcs
