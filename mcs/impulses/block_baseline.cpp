#include "mcs/impulses/block_lanes.hpp"

namespace fpkcheck::mcs {

Block baseline::make_block(const Excitation& excitation, const Uniforms& uniforms) {
  return make_block_in_lanes(excitation, uniforms);
}

}  // namespace fpkcheck::mcs
