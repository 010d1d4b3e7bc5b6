#include "mcs/motion/general_simd.hpp"

namespace fpkcheck::mcs {

void avx512::advance_general_streams(const GeneralMotionParameters& motion, Stream* const* streams,
                                     int width) {
  advance_any_oscillator<8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
