#include "mcs/motion/advance.hpp"

#include "mcs/motion/simd_dispatch.hpp"

namespace fpkcheck::mcs {

void advance(const Motion& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->begin(*stream);
  }
  advance_in_simd_groups<Motion>(motion, streams, lanes, baseline::advance_streams,
                                 avx2::advance_streams, avx512::advance_streams);
}

}  // namespace fpkcheck::mcs
