#pragma once

#include <span>

#include "mcs/motion/oscillator.hpp"
#include "mcs/streams/splitting.hpp"
#include "mcs/streams/stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// What is the same for all streams.
struct Motion {
  Oscillator oscillator;
  double step;               ///< longest flight, in radians (BasicFlight::reach)
  double sampling_interval;  ///< time between samples
  const BinFinder* y_bins;
  const BinFinder* v_bins;
  const Splitting* splitting = nullptr;  ///< none: every stream is one branch
  bool records = true;                   ///< false: for the burn-in
  double shift = 0;                      ///< Excitation::shift
  const DepositPlan* deposit = nullptr;  ///< none: samples are counted only
};

/// Moves streams on by a time, event by event: paper (1)-(2) itself, flights ending exactly at
/// impacts, at impulses and at the end of the time. Each lane has its own time; a lane whose time
/// is over waits for the others.
///
/// What a stream does depends on nothing but the stream: not on its neighbours, their number or the
/// instructions used.
/// @param streams any number; as many as there are lanes go side by side
void advance(const Motion& motion, std::span<Stream* const> streams, double time,
             const simd::LaneSet& lanes);

// As many streams as `width`, whose remaining time is set: the same function, compiled for
// different instructions.
namespace baseline {
void move(const Motion& motion, Stream* const* streams, int width);
}
namespace avx2 {
void move(const Motion& motion, Stream* const* streams, int width);
}
namespace avx512 {
void move(const Motion& motion, Stream* const* streams, int width);
}

}  // namespace fpkcheck::mcs
