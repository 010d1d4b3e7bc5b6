#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "mcs/deposit/deposit.hpp"
#include "mcs/impulses/impulse_source.hpp"
#include "mcs/streams/histogram.hpp"

namespace fpkcheck::mcs {

/// Exponents (p, q) of the estimated means of y^p y'^q, 1 <= p + q <= kHighestPower.
inline constexpr std::size_t kHighestPower = 4;
inline constexpr std::array<std::pair<int, int>, 14> kPowers{{{1, 0},
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

/// Statistics of one stream: sums over samples and events. Each term has the weight of its branch,
/// which is 1 without splitting.
struct StreamRecord {
  Histogram histogram;
  std::vector<double> peaks;  ///< maxima of y in the bins of y, with the outer bins
  /// Minima of y above the wall in the bins of y, with the outer bins
  std::vector<double> troughs;
  std::array<double, kPowers.size()> powers{};
  /// Sums of y^5 and y^6 over samples. Only forces of degree 4 or 5 need these sums; flights whose
  /// step is limited by the energy (cubic forces) do not compute them.
  double y5 = 0, y6 = 0;
  double samples = 0;
  double rest_left = 0;               ///< weight of samples at rest in contact with the left wall;
                                      ///< these samples are not in the histogram
  double rest_right = 0;              ///< weight of samples at rest in contact with the right wall
  double impacts = 0;                 ///< number of impacts on both walls
  double left_speed = 0;              ///< sum of |v| over impacts on the left wall
  double left_energy = 0;             ///< sum of v^2 over impacts on the left wall
  double right_speed = 0;             ///< sum of |v| over impacts on the right wall
  double right_energy = 0;            ///< sum of v^2 over impacts on the right wall
  double work = 0;                    ///< work of the impulses, see Excitation::work
  std::uint64_t impulses = 0;         ///< number of impulses of the main branch
  std::uint64_t branch_impulses = 0;  ///< number of impulses of all other branches
  std::uint64_t flights = 0;
  /// Histogram of the energies right after impulses, in ImportanceSplitting::energy_bins(); empty
  /// without splitting.
  std::vector<double> energies{};
  /// Sums deposited on the grid of Options::deposit; empty without such a grid.
  DepositedSums deposit{};

  StreamRecord(const BinFinder& y, const BinFinder& v)
      : histogram(y, v), peaks(y.bin_count() + 2), troughs(y.bin_count() + 2) {}
};

/// Calls `visit` with every member of a record that holds sums, in the order of checkpoint files.
template <class Record, class Visit>
void for_each_sum(Record& record, Visit visit) {
  visit(record.powers);
  for (auto* sum : {&record.y5, &record.y6, &record.samples, &record.rest_left, &record.rest_right,
                    &record.impacts, &record.left_speed, &record.left_energy, &record.right_speed,
                    &record.right_energy, &record.work}) {
    visit(*sum);
  }
  for (auto* number : {&record.impulses, &record.branch_impulses, &record.flights}) {
    visit(*number);
  }
  visit(record.histogram.weights());
  visit(record.peaks);
  visit(record.troughs);
  visit(record.energies);
  if (!record.deposit.flow.empty()) for_each_deposit_sum(record.deposit, visit);
}

/// Current state of a branch of the trajectory, and the times until its next events.
struct Branch {
  double y;
  double v;
  double until_impulse;
  double amplitude;  ///< amplitude of the next impulse
  double until_sample;
  double remaining;  ///< time to simulate
  /// Time until the next kick of the Gaussian noise; infinite without noise
  double until_kick = std::numeric_limits<double>::infinity();
  double kick_interval = 0;  ///< length of the interval that ends with the next kick
  /// Time until the bounces on a wall end; 0 at rest in contact, -1 during free motion.
  double time_to_rest = -1;
  int energy_level = 0;  ///< number of splitting thresholds below the energy
  int floor_level = 0;   ///< the branch ends when energy_level falls below this level
  /// Bit i is set if threshold i + 1 has split the branch during its rise (ImportanceSplitting).
  std::uint64_t split = 0;
};

/// A pending branch of a stream, or several pending branches with the same initial state.
struct PendingBranch {
  Branch branch;
  /// Number of pending branches, each of which draws its next impulse. If 0, there is one branch
  /// whose next impulse is stored.
  int copies = 0;
  bool at_impulse = false;  ///< whether each copy also draws the time of its next impulse
};

/// One realisation of the stochastic process: its state, its random number generators and its
/// statistics.
struct Stream {
  Branch branch;
  ImpulseSource source;
  StreamRecord record;
  /// Pending branches, the main branch first. ImportanceSplitting bounds their number.
  std::vector<PendingBranch> pending_branches{};
  NoiseSource noise{0, 0};  ///< normal numbers of the Gaussian noise

  /// Whether the current branch is the main branch of the stream.
  bool is_on_main_branch() const { return pending_branches.empty(); }
};

}  // namespace fpkcheck::mcs
