#include "mcs/motion/general_lanes.hpp"

namespace fpkcheck::mcs {

void baseline::move_general(const GeneralMotion& motion, Stream* const* streams, int width) {
  move_general_any_of<1, 2, 8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
