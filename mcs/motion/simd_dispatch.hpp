#pragma once

#include <span>

#include "mcs/streams/stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// Type of a function that advances `width` streams by their remaining time.
template <class Motion>
using AdvanceFunction = void(const Motion& motion, Stream* const* streams, int width);

/// Advances any number of streams by their remaining time: full groups in SIMD lanes, the other
/// streams one by one.
template <class Motion>
void advance_in_simd_groups(const Motion& motion, std::span<Stream* const> streams,
                            const simd::CodeVariant& lanes, AdvanceFunction<Motion>* baseline,
                            AdvanceFunction<Motion>* avx2, AdvanceFunction<Motion>* avx512) {
  const auto advance_streams = simd::select_variant(lanes.instructions, baseline, avx2, avx512);
  const auto width = static_cast<std::size_t>(lanes.width);
  std::size_t next = 0;
  for (; next + width <= streams.size(); next += width) {
    advance_streams(motion, streams.data() + next, lanes.width);
  }
  for (; next < streams.size(); ++next) baseline(motion, streams.data() + next, 1);
}

}  // namespace fpkcheck::mcs
