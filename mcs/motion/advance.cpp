#include "mcs/motion/advance.hpp"

#include "mcs/motion/side_by_side.hpp"

namespace fpkcheck::mcs {

void advance(const Motion& motion, std::span<Stream* const> streams, double time,
             const simd::LaneSet& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->begin(*stream);
  }
  move_side_by_side<Motion>(motion, streams, lanes, baseline::move, avx2::move, avx512::move);
}

}  // namespace fpkcheck::mcs
