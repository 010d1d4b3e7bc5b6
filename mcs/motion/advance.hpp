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
  NoiseKicks kicks{};        ///< not with Oscillator::Kind::duffing_at_wall
  double step;               ///< limit of the Taylor step in radians (DuffingFlight::max_step)
  double sampling_interval;  ///< time between samples
  const BinFinder* y_bins;
  const BinFinder* v_bins;
  bool records = true;                             ///< false during the burn-in
  const ImportanceSplitting* splitting = nullptr;  ///< null: every stream is one branch
  double shift = 0;                                ///< Excitation::shift
  /// Null: no deposition. Only with Oscillator::Kind::duffing_at_wall
  const DepositPlan* deposit = nullptr;
};

/// Advances streams by the duration `time`, event by event, paper (1)-(2): flights end exactly at
/// impacts, at impulses, at kicks of the noise and at the end of the duration. Each SIMD lane has
/// its own time and does nothing after its end until all lanes have ended. If the force presses the
/// mass on a wall, infinitely many bounces end in finite time. Below the impact speed
/// Wall::rest_speed the geometric series of these bounces is summed, and the mass then rests until
/// the next impulse.
///
/// The result of a stream is independent of the other streams, of the number of streams and of the
/// instruction set.
/// @param streams any number of streams; each SIMD lane advances one stream at a time
/// @pre without `records` there is neither `splitting` nor `deposit`
void advance(const MotionParameters& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes);

/// Time from a kick of the noise at (y, v) to the next kick. Next to a wall with impact losses this
/// time is a fraction of the time in which noise alone changes the motion, v^2/D or
/// (distance^2/D)^(1/3). With a fixed interval the strength of the kicks would limit how near the
/// oscillator comes to rest.
double time_to_next_kick(const MotionParameters& motion, double y, double v);

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
