#include "mcs/motion/advance_simd.hpp"

namespace fpkcheck::mcs {

void baseline::advance_streams(const MotionParameters& motion, Stream* const* streams, int width) {
  advance_with_width<1, 2, 8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
