#include "mcs/motion/advance_lanes.hpp"

namespace fpkcheck::mcs {

void baseline::move(const Motion& motion, Stream* const* streams, int width) {
  move_any_of<1, 2, 8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
