#pragma once

#include <span>

#include "mcs/motion/oscillator.hpp"
#include "mcs/streams/importance_splitting.hpp"
#include "mcs/streams/stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// Parameters of the motion, the sampling and the statistics, the same for all streams.
struct MotionParameters {
  Oscillator oscillator;
  double step;               ///< limit of the Taylor step in radians (BasicFlight::max_step)
  double sampling_interval;  ///< time between samples
  const BinFinder* y_bins;
  const BinFinder* v_bins;
  const ImportanceSplitting* splitting = nullptr;  ///< null: every stream is one branch
  bool records = true;                             ///< false during the burn-in
  double shift = 0;                                ///< Excitation::shift
  const DepositPlan* deposit = nullptr;            ///< null: no deposition
};

/// Advances streams by the duration `time`, event by event, paper (1)-(2): flights end exactly at
/// impacts, at impulses and at the end of the duration. Each SIMD lane has its own time and does
/// nothing after its end until all lanes have ended.
///
/// The result of a stream is independent of the other streams, of the number of streams and of the
/// instruction set.
/// @param streams any number of streams; each SIMD lane advances one stream at a time
void advance(const MotionParameters& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes);

// Advances `width` streams by their remaining time. One function, compiled for three instruction
// sets.
namespace baseline {
void advance_streams(const MotionParameters& motion, Stream* const* streams, int width);
}
namespace avx2 {
void advance_streams(const MotionParameters& motion, Stream* const* streams, int width);
}
namespace avx512 {
void advance_streams(const MotionParameters& motion, Stream* const* streams, int width);
}

}  // namespace fpkcheck::mcs
