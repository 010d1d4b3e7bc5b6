#pragma once

#include <type_traits>

#include "mcs/impulses/block.hpp"
#include "mcs/impulses/standard_amplitude.hpp"

// Compiled for several instruction sets, as motion/advance_simd.hpp.
namespace fpkcheck::mcs {
namespace {

constexpr int kWide = 8;
using Wide = simd::LanesOf<kWide>::Real;

template <class Law>
FPKCHECK_INLINE void make_amplitudes(const Excitation& excitation, const Uniforms& u,
                                     Block& block) {
  if constexpr (std::is_base_of_v<DrawnFromPieces, StandardAmplitude<Law>>) {
    for (std::size_t k = 0; k < kBlock; ++k) {
      block.amplitude[k] = excitation.mean + excitation.width * (*excitation.pieces)(u.second[k]);
    }
    return;
  } else {
    for (int k = 0; k < kBlock; k += kWide) {
      const Wide standard =
          StandardAmplitude<Law>::of(simd::load<Wide>(&u.second[k]), simd::load<Wide>(&u.third[k]));
      simd::store<Wide>(excitation.mean + excitation.width * standard, &block.amplitude[k]);
    }
  }
}

template <class... Laws>
FPKCHECK_INLINE void make_amplitudes_of(LawList<Laws...>, const Excitation& excitation,
                                        const Uniforms& u, Block& block) {
  int place = 0;
  ((place++ == excitation.law ? make_amplitudes<Laws>(excitation, u, block) : void()), ...);
}

FPKCHECK_INLINE Block make_block_in_lanes(const Excitation& excitation, const Uniforms& u) {
  Block block;
  const bool poisson = excitation.arrivals == Excitation::Arrivals::poisson;
  for (int k = 0; k < kBlock; k += kWide) {
    const Wide wait = poisson
                          ? -simd::logarithm(simd::load<Wide>(&u.first[k])) * excitation.interval
                          : simd::all_lanes<Wide>(excitation.interval);
    simd::store<Wide>(wait, &block.waiting[k]);
  }
  make_amplitudes_of(DrawnLaws(), excitation, u, block);
  return block;
}

}  // namespace
}  // namespace fpkcheck::mcs
