#include "mcs/motion/advance.hpp"

#include "mcs/motion/simd_dispatch.hpp"

namespace fpkcheck::mcs {

void advance(const MotionParameters& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->split_initial_state(*stream);
  }
  advance_in_simd_groups<MotionParameters>(motion, streams, lanes, baseline::advance_streams,
                                           avx2::advance_streams, avx512::advance_streams);
}

}  // namespace fpkcheck::mcs
