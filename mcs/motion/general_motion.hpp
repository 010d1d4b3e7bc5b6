#pragma once

#include <span>

#include "mcs/motion/general_oscillator.hpp"
#include "mcs/streams/splitting.hpp"
#include "mcs/streams/stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// What is the same for all streams of an oscillator that is not the paper's.
struct GeneralMotion {
  GeneralOscillator oscillator;
  GeneralKicks kicks;
  double step;               ///< longest flight, in radians
  double sampling_interval;  ///< time between samples
  const BinFinder* y_bins;
  const BinFinder* v_bins;
  bool records = true;                   ///< false: for the burn-in
  const Splitting* splitting = nullptr;  ///< none: every stream is one branch
};

/// Moves streams on by a time, event by event, as advance() of the paper's oscillator does. Where the
/// force presses on a wall, infinitely many bounces end in finite time: below GeneralWall::slow they
/// are summed up as the geometric series that they are, and the mass is at rest until the next impulse.
///
/// What a stream does depends on nothing but the stream: not on its neighbours, their number or the
/// instructions used.
void advance(const GeneralMotion& motion, std::span<Stream* const> streams, double time,
             const simd::LaneSet& lanes);

/// The time to the kick after the one at (y, v). Next to a wall that takes energy it is a part of the
/// time in which noise alone changes the motion, v^2/D or (distance^2/D)^(1/3): else kicks would
/// decide how near to rest the oscillator comes.
double kick_interval(const GeneralMotion& motion, double y, double v);

// As many streams as `width`, whose remaining time is set: the same function, compiled for
// different instructions.
namespace baseline {
void move_general(const GeneralMotion& motion, Stream* const* streams, int width);
}
namespace avx2 {
void move_general(const GeneralMotion& motion, Stream* const* streams, int width);
}
namespace avx512 {
void move_general(const GeneralMotion& motion, Stream* const* streams, int width);
}

}  // namespace fpkcheck::mcs
