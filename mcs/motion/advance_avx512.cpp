#include "mcs/motion/advance_lanes.hpp"

namespace fpkcheck::mcs {

void avx512::move(const Motion& motion, Stream* const* streams, int width) {
  move_any_of<8>(motion, streams, width);
}

}  // namespace fpkcheck::mcs
