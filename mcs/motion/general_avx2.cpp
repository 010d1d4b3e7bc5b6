#include "mcs/motion/general_simd.hpp"

namespace fpkcheck::mcs {

void avx2::advance_general_streams(const GeneralMotionParameters& motion, Stream* const* streams,
                                   int width) {
  advance_any_oscillator<4>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
