#include "mcs/motion/advance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::mcs {
namespace {

/// Advances any number of streams by the duration `time`: full groups in SIMD lanes, the other
/// streams one by one.
template <class Parameters>
void advance_in_simd_groups(const Parameters& motion, std::span<Stream* const> streams, double time,
                            const simd::CodeVariant& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->split_initial_state(*stream);
  }
  using AdvanceFunction = void(const Parameters&, Stream* const*, int);
  const auto advance_streams =
      simd::select_variant<AdvanceFunction>(lanes.instructions, baseline::advance_streams,
                                            avx2::advance_streams, avx512::advance_streams);
  const auto width = static_cast<std::size_t>(lanes.width);
  std::size_t next = 0;
  for (; next + width <= streams.size(); next += width) {
    advance_streams(motion, streams.data() + next, lanes.width);
  }
  for (; next < streams.size(); ++next) {
    baseline::advance_streams(motion, streams.data() + next, 1);
  }
}

}  // namespace

void advance(const MotionParameters& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes) {
  advance_in_simd_groups(motion, streams, time, lanes);
}

void advance(const GeneralMotionParameters& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes) {
  advance_in_simd_groups(motion, streams, time, lanes);
}

double time_to_next_kick(const GeneralMotionParameters& motion, double y, double v) {
  const auto& [diffusion, damping, longest_interval, shortest_interval, has_lossy_wall] =
      motion.kicks;
  if (!has_lossy_wall) return longest_interval;
  constexpr double kPart = 0.1;
  const double in_velocity = kPart * v * v / diffusion;
  if (in_velocity >= longest_interval) return longest_interval;
  double distance = std::numeric_limits<double>::infinity();
  for (const GeneralWall* wall : {&motion.oscillator.left, &motion.oscillator.right}) {
    if (!wall->exists || wall->restitution == 1) continue;
    distance = std::min(distance, std::abs(y - wall->position));
  }
  const double in_distance = kPart * std::cbrt(distance * distance / diffusion);
  return std::clamp(std::max(in_velocity, in_distance), shortest_interval, longest_interval);
}

}  // namespace fpkcheck::mcs
