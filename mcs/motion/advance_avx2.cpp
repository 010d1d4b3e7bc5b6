#include "mcs/motion/advance_lanes.hpp"

namespace fpkcheck::mcs {

void avx2::move(const Motion& motion, Stream* const* streams, int width) {
  move_any_of<4>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
