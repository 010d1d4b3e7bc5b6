#include "mcs/motion/general_simd.hpp"

namespace fpkcheck::mcs {

void baseline::advance_general_streams(const GeneralMotionParameters& motion,
                                       Stream* const* streams, int width) {
  advance_any_oscillator<1, 2, 8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
