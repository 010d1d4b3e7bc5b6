#pragma once

#include <span>

#include "mcs/streams/stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// Advances `width` streams by their remaining time.
template <class Motion>
using MoveStreams = void(const Motion& motion, Stream* const* streams, int width);

/// Advances any number of streams: full groups in SIMD lanes, the remaining streams one by one.
template <class Motion>
void move_side_by_side(const Motion& motion, std::span<Stream* const> streams,
                       const simd::LaneSet& lanes, MoveStreams<Motion>* baseline,
                       MoveStreams<Motion>* avx2, MoveStreams<Motion>* avx512) {
  const auto move = simd::compiled_for(lanes.instructions, baseline, avx2, avx512);
  const auto width = static_cast<std::size_t>(lanes.width);
  std::size_t next = 0;
  for (; next + width <= streams.size(); next += width) {
    move(motion, streams.data() + next, lanes.width);
  }
  for (; next < streams.size(); ++next) baseline(motion, streams.data() + next, 1);
}

}  // namespace fpkcheck::mcs
