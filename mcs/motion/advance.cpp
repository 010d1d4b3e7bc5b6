#include "mcs/motion/advance.hpp"

namespace fpkcheck::mcs {

void advance(const Motion& motion, std::span<Stream* const> streams, double time,
             const LaneSet& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->begin(*stream);
  }
  const auto move = compiled_for(lanes.instructions, baseline::move, avx2::move, avx512::move);
  const auto width = static_cast<std::size_t>(lanes.width);
  std::size_t next = 0;
  for (; next + width <= streams.size(); next += width) {
    move(motion, streams.data() + next, lanes.width);
  }
  for (; next < streams.size(); ++next) baseline::move(motion, streams.data() + next, 1);
}

}  // namespace fpkcheck::mcs
