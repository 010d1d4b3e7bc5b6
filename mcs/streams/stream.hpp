#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mcs/deposit/deposit.hpp"
#include "mcs/impulses/impulse_source.hpp"
#include "mcs/impulses/noise_source.hpp"
#include "mcs/streams/histogram.hpp"

namespace fpkcheck::mcs {

/// The powers y^p y'^q, 1 <= p + q <= kHighestPower, whose means are estimated.
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

/// What a stream sees besides where the oscillator is not the paper's; likewise sums.
struct GeneralSums {
  double y5 = 0, y6 = 0;  ///< of y^5 and y^6 over samples: a force may have the degree 5
  double right_speed = 0, right_energy = 0;  ///< of v and v^2 over impacts on the right
  double rest_left = 0, rest_right = 0;      ///< samples at rest in contact; not in the histogram
  double kicks = 0;                          ///< how many stood for Gaussian noise
};

/// What one stream has seen: sums over samples and events, each with the weight of its branch
/// (1 without splitting).
struct StreamRecord {
  Histogram histogram;
  std::vector<double> peaks;    ///< maxima of y by the bins of y, with the outer bins
  std::vector<double> troughs;  ///< minima of y above the wall, likewise
  std::array<double, kPowers.size()> powers{};
  double samples = 0;
  double impacts = 0;
  double impact_speed = 0;            ///< sum of |v| over impacts
  double impact_energy = 0;           ///< sum of v^2 over impacts
  double work = 0;                    ///< of the impulses, see Excitation::work
  std::uint64_t impulses = 0;         ///< of the stream itself, without its branches
  std::uint64_t branch_impulses = 0;  ///< of its branches alone
  std::uint64_t flights = 0;
  /// Energies right after impulses, by the bins of the splitting; empty without.
  std::vector<double> energies{};
  /// On the grid of Options::deposit; empty without.
  Deposit deposit{};
  /// Only of an oscillator that is not the paper's.
  std::optional<GeneralSums> general{};

  StreamRecord(const BinFinder& y, const BinFinder& v)
      : histogram(y, v), peaks(y.bins() + 2), troughs(y.bins() + 2) {}
};

/// Shows every sum of a record to `visit`, in the order in which checkpoints have them.
template <class Record, class Visit>
void for_each_sum(Record& record, Visit visit) {
  visit(record.powers);
  visit(record.samples);
  visit(record.impacts);
  visit(record.impact_speed);
  visit(record.impact_energy);
  visit(record.work);
  visit(record.impulses);
  visit(record.branch_impulses);
  visit(record.flights);
  visit(record.histogram.weights());
  visit(record.peaks);
  visit(record.troughs);
  visit(record.energies);
  if (!record.deposit.flow.empty()) for_each_deposit_sum(record.deposit, visit);
  if (record.general) {
    auto& sums = *record.general;
    for (auto* sum : {&sums.y5, &sums.y6, &sums.right_speed, &sums.right_energy, &sums.rest_left,
                      &sums.rest_right, &sums.kicks}) {
      visit(*sum);
    }
  }
}

/// A trajectory somewhere on its way.
struct Branch {
  double y;
  double v;
  double until_impulse;
  double amplitude;  ///< of that impulse
  double until_sample;
  double remaining;  ///< time
  int level = 0;     ///< of the splitting
  int floor = 0;     ///< the branch ends where its level falls below
  /// Bit i: threshold i + 1 made kCopies branches of one on the way to this level (Splitting).
  std::uint64_t split = 0;
};

/// What a trajectory has besides where the oscillator is not the paper's.
struct GeneralBranch {
  double until_kick = std::numeric_limits<double>::infinity();
  double kick_interval = 0;  ///< that ends with the next kick
  /// Time until bounces on a wall have come to rest, 0 from then on; -1 where the motion is free.
  double bouncing = -1;
};

/// A branch of a stream that is to be followed, or several that begin alike.
struct WaitingBranch {
  Branch branch;
  GeneralBranch general;
  /// How many, each with an impulse to come of its own; 0: the branch as it is.
  int copies = 0;
  bool at_impulse = false;  ///< the time until that impulse is their own, too
};

/// One realisation with its random numbers and what it has seen.
struct Stream {
  Branch branch;
  ImpulseSource source;
  StreamRecord record;
  /// Branches to be followed, the stream itself first; no more than Splitting states.
  std::vector<WaitingBranch> waiting{};
  GeneralBranch general{};
  NoiseSource noise{0, 0};  ///< for Gaussian noise

  /// The stream itself moves, not one of its branches.
  bool whole() const { return waiting.empty(); }
};

}  // namespace fpkcheck::mcs
