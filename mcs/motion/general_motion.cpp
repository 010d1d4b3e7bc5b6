#include "mcs/motion/general_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mcs/motion/simd_dispatch.hpp"

namespace fpkcheck::mcs {

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

void advance(const GeneralMotionParameters& motion, std::span<Stream* const> streams, double time,
             const simd::CodeVariant& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->split_initial_state(*stream);
  }
  advance_in_simd_groups<GeneralMotionParameters>(
      motion, streams, lanes, baseline::advance_general_streams, avx2::advance_general_streams,
      avx512::advance_general_streams);
}

}  // namespace fpkcheck::mcs
