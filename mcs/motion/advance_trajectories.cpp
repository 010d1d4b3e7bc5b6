#include "mcs/motion/advance_trajectories.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "numerics/statistics.hpp"
#include "problem/noise_factor.hpp"
#include "problem/time_dependence.hpp"

namespace fpkcheck::mcs {

void advance_all_streams(const StreamMotionParameters& motion,
                         std::span<TrajectoryStream* const> streams, double duration,
                         const simd::SimdVariant& simd_variant) {
  assert(motion.records || (!motion.splitting && !motion.deposit && !motion.keeps_states));
  assert(!(motion.records_displacement_series || motion.keeps_states) || !motion.splitting);
  assert(!motion.kicks.is_acting() || !motion.oscillator.is_duffing_at_wall());
  assert(!motion.deposit || motion.oscillator.is_duffing_at_wall());
  for (TrajectoryStream* stream : streams) {
    stream->branch.remaining = duration;
    if (motion.splitting) motion.splitting->split_initial_state(*stream);
  }
  const auto advance_trajectory_streams =
      simd::select_variant(simd_variant.instructions, baseline::advance_trajectory_streams,
                           avx2::advance_trajectory_streams, avx512::advance_trajectory_streams);
  const auto width = static_cast<std::size_t>(simd_variant.width);
  std::size_t next = 0;
  for (; next + width <= streams.size(); next += width) {
    advance_trajectory_streams(motion, streams.data() + next, simd_variant.width);
  }
  for (; next < streams.size(); ++next) {
    baseline::advance_trajectory_streams(motion, streams.data() + next, 1);
  }
}

double noise_intensity_factor(const StreamMotionParameters& motion,
                              const TrajectoryBranch& branch) {
  if (motion.time_dependence == nullptr) return 1;
  return motion.time_dependence->intensity_factor(motion.end_time - branch.remaining);
}

bool accept_impulse_by_thinning(const StreamMotionParameters& motion, TrajectoryStream& stream) {
  if (motion.time_dependence == nullptr || !motion.time_dependence->has_rate_factor()) return true;
  const double uniform = numerics::normal_probability(stream.noise.next_normal());
  return uniform < motion.time_dependence->rate_factor(motion.end_time - stream.branch.remaining);
}

double time_to_next_kick(const StreamMotionParameters& motion, double diffusion, double y,
                         double v) {
  const double longest_interval = motion.kicks.longest_interval;
  if (!motion.kicks.has_lossy_wall) return longest_interval;
  if (motion.kicks.factor != nullptr) diffusion *= motion.kicks.factor->squared_noise_factor(y, v);
  if (diffusion == 0) return longest_interval;
  const double fraction = motion.kicks.fraction_near_wall;
  const double in_velocity = fraction * v * v / diffusion;
  if (in_velocity >= longest_interval) return longest_interval;
  double distance = std::numeric_limits<double>::infinity();
  for (const SimulatedWall* wall : {&motion.oscillator.left, &motion.oscillator.right}) {
    if (!wall->has_impact_losses()) continue;
    distance = std::min(distance, std::abs(y - wall->position));
  }
  const double in_distance = fraction * std::cbrt(distance * distance / diffusion);
  return std::clamp(std::max(in_velocity, in_distance), motion.kicks.shortest_interval,
                    longest_interval);
}

}  // namespace fpkcheck::mcs
