#pragma once

#include <span>

#include "mcs/motion/oscillator.hpp"
#include "mcs/streams/importance_splitting.hpp"
#include "mcs/streams/trajectory_stream.hpp"
#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

/// Parameters of motion, sampling and statistics that all trajectory streams have in common.
struct StreamMotionParameters {
  SimulatedOscillator oscillator;
  NoiseKicks kicks{};  ///< noise kicks; absent with SimulatedOscillator::Kind::duffing_at_wall
  /// Limit of the time step of Taylor series in radians (DuffingFlight::max_flight_duration)
  double step;
  double sampling_interval;
  const BinFinder* y_bins;
  const BinFinder* v_bins;
  bool records = true;  ///< whether statistics are recorded; false during the burn-in
  const ImportanceSplitting* splitting = nullptr;  ///< importance splitting; null if disabled
  double shift = 0;  ///< shift of the velocity impulses, ImpulseProcess::shift
  bool records_displacement_series =
      false;  ///< whether samples of y are appended to TrajectoryStream::series
  /// Whether the oscillator states at samples, impulses and noise kicks are appended to
  /// TrajectoryStream::states; must be false for kicks of multiplicative noise
  bool keeps_states = false;
  /// Plan of the deposition of samples on splines; null if samples are not deposited. Samples can
  /// be deposited only with SimulatedOscillator::Kind::duffing_at_wall.
  const SampleDepositionPlan* deposit = nullptr;
  /// Formulas of a time-dependent excitation; null for a constant excitation
  const problem::ExcitationTimeDependence* time_dependence = nullptr;
  double end_time = 0;  ///< time at the end of advance_all_streams(), used with `time_dependence`
};

/// Returns the factor b(t) of the noise intensity at the present time t of a trajectory branch.
double noise_intensity_factor(const StreamMotionParameters& motion, const TrajectoryBranch& branch);
/// Returns true with the probability a(t), the ratio of the impulse rate at the time t to the
/// largest impulse rate. If accept_impulse_by_thinning() returns true, the stream receives an
/// impulse drawn at the largest impulse rate (thinning of a Poisson process).
bool accept_impulse_by_thinning(const StreamMotionParameters& motion, TrajectoryStream& stream);

/// Advances trajectory streams by `duration`, event by event, paper (1)-(2). Free flights end
/// exactly at impacts, at impulses, at noise kicks and at the end of `duration`. If the contact
/// force presses the mass on a wall, infinitely many bounces end in finite time. Below the impact
/// speed SimulatedWall::rest_speed the geometric series of the bounces is summed, and the mass then
/// rests until the next impulse.
///
/// The result of a trajectory stream does not depend on other streams, on the number of streams or
/// on the instruction set.
/// @param streams any number of trajectory streams; each SIMD lane advances one stream
/// @pre `splitting`, `deposit` and `keeps_states` require `records`, and `splitting` excludes
/// `records_displacement_series` and `keeps_states`
void advance_all_streams(const StreamMotionParameters& motion,
                         std::span<TrajectoryStream* const> streams, double duration,
                         const simd::SimdVariant& simd_variant);

/// Returns the time from a noise kick at the state (y, v) to the next noise kick. Next to a wall
/// with impact losses the kick interval is a fraction of v^2/D or (distance^2/D)^(1/3), the times
/// in which noise alone changes speed v and distance from the wall. With a constant kick interval
/// the strength of the kicks would prevent the oscillator from coming close to rest.
/// @param diffusion present diffusion coefficient D, without the factor of multiplicative noise
double time_to_next_kick(const StreamMotionParameters& motion, double diffusion, double y,
                         double v);

// The functions advance_trajectory_streams() of three namespaces advance `stream_count` streams,
// each by its remaining time. The source code of advance_trajectory_streams() is compiled for three
// instruction sets.
namespace baseline {
void advance_trajectory_streams(const StreamMotionParameters& motion,
                                TrajectoryStream* const* streams, int stream_count);
}
namespace avx2 {
void advance_trajectory_streams(const StreamMotionParameters& motion,
                                TrajectoryStream* const* streams, int stream_count);
}
namespace avx512 {
void advance_trajectory_streams(const StreamMotionParameters& motion,
                                TrajectoryStream* const* streams, int stream_count);
}

}  // namespace fpkcheck::mcs
