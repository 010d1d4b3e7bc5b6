#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "mcs/streams/stream.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::mcs {

/// Importance splitting by RESTART (Villen-Altamirano, ITC 13, 1991) on the chain of states right
/// after impulses, where alone the energy rises. (Where something else raised it too there would be
/// no bias, but the tails would not be visited more often for it.)
///
/// A branch whose energy E = v^2/2 + V(y) rises above a threshold becomes `kCopies`
/// branches, which go on with random numbers of their own. All but one end when they fall below the
/// threshold that made them. What a branch sees counts 1/kCopies for each threshold that split it on
/// its way to its level: an unbiased estimate of the same time averages, with as many visits to the
/// tails as to the middle where every threshold splits.
///
/// Not every threshold splits. A rule that uses the past alone leaves the estimate unbiased: a split
/// keeps the sum of the weights, and the copies take random numbers that no earlier decision has used.
/// Three rules bound memory and time:
/// - An impulse across many thresholds splits at the highest kMostSplits of them, into 4^3 = 64
///   branches. Without this rule one exponential amplitude across 12 thresholds makes 4^12 branches.
/// - Branches with the same state wait as one entry. The floors of waiting branches increase, so that
///   L thresholds have at most L (L + 3)/2 entries.
/// - A stream stops splitting while its branches have received more than kFreeImpulses +
///   kImpulsesPerLevel * L times the impulses of the stream itself. Thresholds a probability of
///   1/kCopies apart give about L times as many, so that this rule acts on ill-placed thresholds only.
class Splitting {
 public:
  static constexpr int kCopies = 4;
  static constexpr int kMostSplits = 3;
  static constexpr int kMostThresholds = 32;
  static constexpr int kImpulsesPerLevel = 4;
  static constexpr std::uint64_t kFreeImpulses = 1000;

  /// @param potential V, 0 at the least
  /// @param thresholds increasing energies; may be empty; at most kMostThresholds are used
  /// @param largest_energy of the bins in which energies are counted
  Splitting(const numerics::Polynomial& potential, std::vector<double> thresholds,
            double largest_energy);

  double weight(const Branch& branch) const {
    return weights_[static_cast<std::size_t>(std::popcount(branch.split))];
  }
  int levels() const { return static_cast<int>(thresholds_.size()); }
  const std::vector<double>& thresholds() const { return thresholds_; }
  const BinFinder& energy_bins() const { return energy_bins_; }

  /// After an impulse: splits the stream's branch, or ends it and goes on with the next one.
  void after_impulse(Stream& stream) const;
  /// Makes the branches that belong to the level on which the stream's time begins.
  void begin(Stream& stream) const;

 private:
  double energy(const Branch& branch) const;
  int level(double energy) const;
  bool may_split(const StreamRecord& record) const;
  void split(Stream& stream, int from, bool at_impulse) const;

  numerics::Polynomial potential_;
  std::vector<double> thresholds_;
  std::vector<double> weights_;
  BinFinder energy_bins_;
};

/// The next branch in waiting, which goes on at once; needs one.
void follow_next(Stream& stream);

/// Thresholds that a branch passes with a probability of about 1/kCopies each, until the energy is
/// exceeded in less than `rarest` of the time after impulses.
/// @param energies weights by energy bins, over all streams
std::vector<double> thresholds_from(const BinFinder& bins, const std::vector<double>& energies,
                                    double fewest_visits, double rarest);

}  // namespace fpkcheck::mcs
