#include "mcs/motion/advance_simd.hpp"

namespace fpkcheck::mcs {

void avx2::advance_streams(const MotionParameters& motion, Stream* const* streams, int width) {
  advance_with_width<4>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
