#pragma once

#include <span>

#include "mcs/motion/oscillator.hpp"
#include "mcs/streams/splitting.hpp"
#include "mcs/streams/stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// Parameters that all streams share.
struct Motion {
  Oscillator oscillator;
  double step;               ///< step limit in radians (BasicFlight::max_step)
  double sampling_interval;  ///< time between samples
  const BinFinder* y_bins;
  const BinFinder* v_bins;
  const Splitting* splitting = nullptr;  ///< null: every stream is one branch
  bool records = true;                   ///< false during the burn-in
  double shift = 0;                      ///< Excitation::shift
  const DepositPlan* deposit = nullptr;  ///< null: no deposition
};

/// Advances streams by a time, event by event, paper (1)-(2): flights end exactly at impacts, at
/// impulses and at the end of the time. Each SIMD lane has its own time; a lane at its end waits
/// for the others.
///
/// The result of a stream depends on this stream alone: not on the other streams, their number or
/// the instruction set.
/// @param streams any number; one per SIMD lane at a time
void advance(const Motion& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes);

// Advances `width` streams by their remaining time. One function, compiled for three instruction
// sets.
namespace baseline {
void advance_streams(const Motion& motion, Stream* const* streams, int width);
}
namespace avx2 {
void advance_streams(const Motion& motion, Stream* const* streams, int width);
}
namespace avx512 {
void advance_streams(const Motion& motion, Stream* const* streams, int width);
}

}  // namespace fpkcheck::mcs
