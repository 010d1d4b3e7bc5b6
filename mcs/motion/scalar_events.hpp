#pragma once

#include "mcs/motion/advance_trajectories.hpp"
#include "numerics/simd/elementary_functions.hpp"

// scalar_events.hpp applies impulses and noise kicks to single trajectory streams, and is compiled
// for several instruction sets.
namespace fpkcheck::mcs {
namespace {

/// Returns the statistical weight of the current trajectory branch; 1 without importance splitting.
inline double branch_statistical_weight(const StreamMotionParameters& motion,
                                        const TrajectoryStream& stream) {
  return motion.splitting ? motion.splitting->branch_statistical_weight(stream.branch) : 1.0;
}

/// Counts an extreme of y if the velocity changes sign in a jump from `v_before` to `v_after`.
inline void count_turning_point(const StreamMotionParameters& motion, TrajectoryStream& stream,
                                double v_before, double v_after) {
  if (!motion.records) return;
  const double y = stream.branch.y, event_weight = branch_statistical_weight(motion, stream);
  if (v_before > 0 && v_after < 0) stream.record.peaks[(*motion.y_bins)(y)] += event_weight;
  const bool at_wall = motion.oscillator.left.exists && !(y > 0);
  if (v_before < 0 && v_after > 0 && !at_wall)
    stream.record.troughs[(*motion.y_bins)(y)] += event_weight;
}

/// Appends the present oscillator state of a stream to TrajectoryStream::states, if
/// StreamMotionParameters::keeps_states is true.
inline void record_trajectory_state(const StreamMotionParameters& motion, TrajectoryStream& stream,
                                    RecordedState::Event event, double kick_variance = 0) {
  if (!motion.keeps_states) return;
  const TrajectoryBranch& b = stream.branch;
  stream.states.push_back({b.remaining, b.y, b.v, event, kick_variance});
}

/// Applies one impulse, paper (3), and draws the next impulse.
inline void apply_impulse(const StreamMotionParameters& motion, TrajectoryStream& stream) {
  TrajectoryBranch& b = stream.branch;
  const double before = b.v;
  record_trajectory_state(motion, stream, RecordedState::Event::before_impulse);
  if (!accept_impulse_by_thinning(motion, stream)) b.amplitude = 0;
  const double factor = impulse_factor(motion.oscillator, b.y);
  b.v += factor * b.amplitude;
  record_trajectory_state(motion, stream, RecordedState::Event::after_impulse);
  b.time_to_rest = -1;
  count_turning_point(motion, stream, before, b.v);
  if (motion.records) {
    const double event_weight = branch_statistical_weight(motion, stream);
    ++(stream.is_on_main_branch() ? stream.record.impulses : stream.record.branch_impulses);
    stream.record.work += event_weight * ((factor * b.amplitude - motion.shift) * before +
                                          b.amplitude * b.amplitude / 2);
    if (motion.deposit) {
      std::array<double, 3>& drawn = stream.record.deposit.impulses;
      drawn[0] += event_weight;
      drawn[1] += event_weight * b.amplitude;
      drawn[2] += event_weight * (b.amplitude * b.amplitude);
    }
  }
  const Impulse next = stream.source.next_impulse();
  b.time_to_impulse = next.waiting_time;
  b.amplitude = next.amplitude;
  if (motion.splitting) motion.splitting->split_or_end_branch_by_energy(stream);
}

/// Returns the parameters of the Ornstein-Uhlenbeck process v' = -c v + sqrt(2 D) W over a time.
inline NoiseKickParameters noise_kick_parameters(double damping, double diffusion, double time) {
  const double x = damping * time;
  const double decay = simd::exponential(simd::lanewise_max(simd::lanewise_min(-x, 300.0), -300.0));
  // The quotient (1 - exp(-2x)) / (2x) is computed by a series at small x, where the difference 1 -
  // exp(-2x) would lose digits.
  const double mean_decay =
      x < 1e-3 && x > -1e-3 ? 1 - x * (1 - 2 * x / 3) : (1 - decay * decay) / (2 * x);
  const double variance = 2 * diffusion * time * mean_decay;
  return {.time = time,
          .diffusion = diffusion,
          .decay = decay,
          .variance = variance,
          .deviation = simd::square_root(variance)};
}

/// Applies the Ornstein-Uhlenbeck process v' = -c v + sqrt(2 D) W for half of the interval before a
/// noise kick plus half of the interval after the noise kick.
inline void apply_noise_kick(const StreamMotionParameters& motion, TrajectoryStream& stream) {
  TrajectoryBranch& b = stream.branch;
  const NoiseKicks& kicks = motion.kicks;
  const double diffusion = kicks.diffusion * noise_intensity_factor(motion, b);
  const double next = time_to_next_kick(motion, diffusion, b.y, b.v);
  const double time = (b.kick_interval + next) / 2;
  NoiseKickParameters& kick_parameters = stream.last_kick;
  if (kick_parameters.time != time || kick_parameters.diffusion != diffusion) {
    kick_parameters = noise_kick_parameters(kicks.damping, diffusion, time);
  }
  const double variance = kick_parameters.variance;
  const double kick = kick_parameters.deviation * stream.noise.next_normal();
  const double before = b.v;
  const double damped = kick_parameters.decay * b.v;
  b.v = damped + kick;
  record_trajectory_state(motion, stream, RecordedState::Event::after_kick, variance);
  b.time_to_rest = -1;
  count_turning_point(motion, stream, before, b.v);
  if (motion.records) {
    // The recorded work of a noise kick has the expectation 0 for any motion.
    stream.record.work += damped * kick + (kick * kick - variance) / 2;
  }
  b.time_to_kick = next;
  b.kick_interval = next;
}

}  // namespace
}  // namespace fpkcheck::mcs
