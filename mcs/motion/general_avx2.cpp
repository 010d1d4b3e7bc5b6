#include "mcs/motion/general_lanes.hpp"

namespace fpkcheck::mcs {

void avx2::move_general(const GeneralMotion& motion, Stream* const* streams, int width) {
  move_general_any_of<4>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
