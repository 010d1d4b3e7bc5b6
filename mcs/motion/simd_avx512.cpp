#include "mcs/impulses/impulse_block_simd.hpp"
#include "mcs/motion/advance_simd.hpp"

namespace fpkcheck::mcs::avx512 {

ImpulseBlock make_impulse_block(const Excitation& excitation, const UniformNumbers& uniforms) {
  return make_impulse_block_in_lanes(excitation, uniforms);
}

void advance_streams(const MotionParameters& motion, Stream* const* streams, int width) {
  advance_with_width<8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs::avx512
