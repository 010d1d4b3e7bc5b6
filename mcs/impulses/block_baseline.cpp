#include "mcs/impulses/block_simd.hpp"

namespace fpkcheck::mcs {

ImpulseBlock baseline::make_impulse_block(const Excitation& excitation,
                                          const UniformNumbers& uniforms) {
  return make_impulse_block_in_lanes(excitation, uniforms);
}

}  // namespace fpkcheck::mcs
