#include "mcs/impulses/impulse_block_simd.hpp"
#include "mcs/motion/advance_simd.hpp"

namespace fpkcheck::mcs::baseline {

ImpulseBlock make_impulse_block(const Excitation& excitation, const UniformNumbers& uniforms) {
  return make_impulse_block_in_lanes(excitation, uniforms);
}

void advance_streams(const MotionParameters& motion, Stream* const* streams, int width) {
  advance_with_width<1, 2>(motion, streams, width);
}

}  // namespace fpkcheck::mcs::baseline
