#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "mcs/deposit/sample_deposit.hpp"
#include "mcs/impulses/impulse_source.hpp"
#include "mcs/streams/histogram.hpp"

namespace fpkcheck::mcs {

/// Exponents (p, q) of the estimated moments E[y^p y'^q], 1 <= p + q <=
/// kHighestRecordedMomentPower.
inline constexpr std::size_t kHighestRecordedMomentPower = 4;
inline constexpr std::array<std::pair<int, int>, 14> kRecordedMomentPowers{{{1, 0},
                                                                            {0, 1},
                                                                            {2, 0},
                                                                            {1, 1},
                                                                            {0, 2},
                                                                            {3, 0},
                                                                            {2, 1},
                                                                            {1, 2},
                                                                            {0, 3},
                                                                            {4, 0},
                                                                            {3, 1},
                                                                            {2, 2},
                                                                            {1, 3},
                                                                            {0, 4}}};

/// Statistics of one trajectory stream: sums over samples and events, weighted with the weight of
/// the branch (1 without importance splitting).
struct TrajectoryStreamStatistics {
  JointHistogram histogram;
  std::vector<double> peaks;  ///< weights of the maxima of y in each bin of y, outer bins included
  /// Weights of the minima of y without wall contact, for each bin of y with the outer bins
  std::vector<double> troughs;
  std::array<double, kRecordedMomentPowers.size()> powers{};
  /// Sums of y^5 and y^6 over samples; 0 with DuffingFlights, for which no balance equation
  /// contains E[y^5] or E[y^6]
  double y5 = 0, y6 = 0;
  /// Sums of f, y f and y' f over samples for SimulatedOscillator::Kind::formula, with the force f
  /// of the equation in Ito's sense; 0 for other kinds
  double force = 0, force_y = 0, force_v = 0;
  double noise_factor = 0;  ///< sum of G = g^2 over samples with multiplicative noise; otherwise 0
  double impulse_factor = 0;  ///< sum of b^2 over samples with parametric impulses; otherwise 0
  double samples = 0;
  double rest_left = 0;  ///< weight of samples at rest on the left wall, which the histogram omits
  /// Sum of the weights of samples at rest on the right wall, which the histogram omits
  double rest_right = 0;
  double impacts = 0;  ///< number of impacts, summed over the left and the right wall
  /// Sum of the momentum changes (1 + r) |v| over impacts on the left wall; for a constant
  /// restitution coefficient r the sum is divided by 1 + r
  double left_momentum = 0;
  /// Sum of the energy losses (1 - r^2) v^2 / 2 over impacts on the left wall; for a constant
  /// restitution coefficient r the sum is divided by (1 - r^2) / 2
  double left_wall_squared_impact_speeds = 0;
  double right_momentum = 0;  ///< the same sum as left_momentum, for the right wall
  /// Sum over impacts on the right wall, defined as left_wall_squared_impact_speeds for the left
  /// wall
  double right_wall_squared_impact_speeds = 0;
  double work = 0;             ///< work of the impulses, defined as in ImpulseProcess::work
  std::uint64_t impulses = 0;  ///< number of impulses of the main branch
  std::uint64_t branch_impulses = 0;
  std::uint64_t flights = 0;
  /// Histogram of the energies right after impulses, in ImportanceSplitting::energy_bins(); empty
  /// without importance splitting
  std::vector<double> energies{};
  /// Sums of spline values for the control variates, on the grid SimulationOptions::deposit; empty
  /// without control variates
  DepositedSampleSums deposit{};

  TrajectoryStreamStatistics(const BinFinder& y, const BinFinder& v)
      : histogram(y, v), peaks(y.bin_count() + 2), troughs(y.bin_count() + 2) {}
};

/// Calls `visit_statistic` with each sum of the statistics of a trajectory stream, in the order of
/// checkpoint files.
template <class Record, class Visit>
void for_each_statistic(Record& record, Visit visit_statistic) {
  visit_statistic(record.powers);
  for (auto* sum : {&record.y5, &record.y6, &record.force, &record.force_y, &record.force_v,
                    &record.noise_factor, &record.impulse_factor, &record.samples,
                    &record.rest_left, &record.rest_right, &record.impacts, &record.left_momentum,
                    &record.left_wall_squared_impact_speeds, &record.right_momentum,
                    &record.right_wall_squared_impact_speeds, &record.work}) {
    visit_statistic(*sum);
  }
  for (auto* number : {&record.impulses, &record.branch_impulses, &record.flights}) {
    visit_statistic(*number);
  }
  visit_statistic(record.histogram.histogram_cell_weights());
  visit_statistic(record.peaks);
  visit_statistic(record.troughs);
  visit_statistic(record.energies);
  if (!record.deposit.flow.empty()) for_each_deposited_sum(record.deposit, visit_statistic);
}

/// State of a trajectory branch, and the times until the next events of the branch.
struct TrajectoryBranch {
  double y;
  double v;
  double time_to_impulse;
  double amplitude;  ///< amplitude of the next impulse
  double time_to_sample;
  double remaining;  ///< remaining time that the branch must simulate
  /// Time until the next kick of the Gaussian noise; infinite without noise
  double time_to_kick = std::numeric_limits<double>::infinity();
  double kick_interval = 0;  ///< kick interval that ends with the next kick
  /// Time until the series of bounces on a wall ends; 0 at rest in contact; -1 during free motion
  double time_to_rest = -1;
  int energy_level = 0;  ///< number of splitting thresholds below the energy of the branch
  int floor_level = 0;   ///< level of the energy below which the branch ends
  /// Bit set of the energy thresholds at which the trajectory branch was split: bit i stands for
  /// threshold i + 1 (ImportanceSplitting).
  std::uint64_t split = 0;
};

/// A pending branch of a trajectory stream, or several pending branches with the same initial
/// state.
struct PendingTrajectoryBranch {
  TrajectoryBranch branch;
  /// Number of pending branches that draw a new impulse; 0 for one branch with a stored impulse
  int copies = 0;
  bool at_impulse = false;  ///< whether each copy also draws the time of its next impulse
};

/// Oscillator state of a trajectory stream at a sample, an impulse or a noise kick.
struct RecordedState {
  enum class Event { sample, before_impulse, after_impulse, after_kick };
  double time_to_end;  ///< time until the end of the round
  double y, v;
  Event event = Event::sample;
  double kick_variance = 0;  ///< variance of the velocity change by a noise kick
};

/// Parameters of the Ornstein-Uhlenbeck process v' = -c v + sqrt(2 D) W over a time, stored from one
/// noise kick to the next, because most kick intervals are equal.
struct NoiseKickParameters {
  double time = 0;       ///< time of the process
  double diffusion = 0;  ///< diffusion coefficient D
  double decay = 1;      ///< factor of the velocity, exp(-c time)
  double variance = 0;   ///< variance of the velocity change
  double deviation = 0;  ///< standard deviation of the velocity change
};

struct TrajectoryStream {
  TrajectoryBranch branch;
  ImpulseSource source;
  TrajectoryStreamStatistics record;
  /// Pending branches of the trajectory stream, with the main branch first
  std::vector<PendingTrajectoryBranch> pending_branches{};
  NoiseSource noise{0, 0};
  NoiseKickParameters last_kick{};  ///< parameters of the last noise kick
  /// Samples of y in the order of time, if StreamMotionParameters::records_displacement_series
  std::vector<double> series{};
  /// Oscillator states in the order of time, if StreamMotionParameters::keeps_states
  std::vector<RecordedState> states{};

  bool is_on_main_branch() const { return pending_branches.empty(); }
};

}  // namespace fpkcheck::mcs
