#include "mcs/motion/general_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mcs/motion/side_by_side.hpp"

namespace fpkcheck::mcs {

double kick_interval(const GeneralMotion& motion, double y, double v) {
  const auto& [diffusion, damping, longest, shortest, graded] = motion.kicks;
  if (!graded) return longest;
  constexpr double kPart = 0.1;
  const double in_velocity = kPart * v * v / diffusion;
  if (in_velocity >= longest) return longest;
  double distance = std::numeric_limits<double>::infinity();
  for (const GeneralWall* wall : {&motion.oscillator.left, &motion.oscillator.right}) {
    if (!wall->stands || wall->restitution == 1) continue;
    distance = std::min(distance, std::abs(y - wall->position));
  }
  const double in_distance = kPart * std::cbrt(distance * distance / diffusion);
  return std::clamp(std::max(in_velocity, in_distance), shortest, longest);
}

void advance(const GeneralMotion& motion, std::span<Stream* const> streams, double time,
             const simd::LaneSet& lanes) {
  for (Stream* stream : streams) {
    stream->branch.remaining = time;
    if (motion.splitting && motion.records) motion.splitting->begin(*stream);
  }
  move_side_by_side<GeneralMotion>(motion, streams, lanes, baseline::move_general,
                                   avx2::move_general, avx512::move_general);
}

}  // namespace fpkcheck::mcs
