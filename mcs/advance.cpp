#include "mcs/advance.hpp"

#include "mcs/instruction_set.hpp"

namespace fpkcheck::mcs {

void advance(const Motion& motion, std::span<Stream* const> streams, double time,
             const LaneSet& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->begin(*stream);
  }
  const auto width = static_cast<std::size_t>(lanes.width);
  std::size_t next = 0;
  for (; next + width <= streams.size(); next += width) {
    switch (lanes.instructions) {
      case InstructionSet::avx512:
        avx512::move(motion, streams.data() + next, lanes.width);
        break;
      case InstructionSet::avx2:
        avx2::move(motion, streams.data() + next, lanes.width);
        break;
      case InstructionSet::baseline:
        baseline::move(motion, streams.data() + next, lanes.width);
        break;
    }
  }
  for (; next < streams.size(); ++next) baseline::move(motion, streams.data() + next, 1);
}

}  // namespace fpkcheck::mcs
