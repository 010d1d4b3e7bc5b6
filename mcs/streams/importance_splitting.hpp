#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "mcs/streams/stream.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::mcs {

/// Importance splitting by RESTART (Villen-Altamirano, ITC 13, 1991) of the chain of states right
/// after impulses. The energy must rise at impulses only. If the energy also rose between impulses,
/// the estimate would stay unbiased, but splitting would not increase the number of visits to the
/// tails.
///
/// The branches of a stream are its trajectory and the copies that splits make of it. A branch
/// whose energy E = v^2/2 + V(y) rises above a threshold is split into `kCopies` branches with
/// independent random numbers. All but one of these end when their energy falls below this
/// threshold. A branch that has been split at n thresholds during its rise has the weight
/// kCopies^-n. The weighted time averages are unbiased. If every threshold splits, the tails of the
/// density are visited as often as its middle.
///
/// Not every threshold splits. A rule that decides from the past alone leaves the estimate
/// unbiased: a split preserves the sum of the weights, and the copies use random numbers on which
/// no earlier decision depends. Three rules bound memory and time:
/// - An impulse across many thresholds splits at the highest kMostSplits of them, into 4^3 = 64
///   branches. Without this rule one exponential amplitude across 12 thresholds makes 4^12
///   branches.
/// - Pending branches with the same state share one entry. The entries have increasing values of
///   floor_level, so L thresholds have at most L (L + 3)/2 entries.
/// - A stream does not split while its other branches have received more than kImpulseAllowance +
///   kImpulsesPerThreshold * L * (impulses of the main branch) impulses. With a probability ratio
///   of 1/kCopies between thresholds the other branches receive about L times as many impulses as
///   the main branch. This rule therefore takes effect for badly spaced thresholds only.
class ImportanceSplitting {
 public:
  static constexpr int kCopies = 4;
  static constexpr int kMostSplits = 3;
  static constexpr int kMostThresholds = 32;
  static constexpr int kImpulsesPerThreshold = 4;
  static constexpr std::uint64_t kImpulseAllowance = 1000;

  /// @param potential potential V, whose minimum is 0
  /// @param thresholds increasing energies; may be empty; at most kMostThresholds are used
  /// @param largest_energy upper end of the energy bins
  ImportanceSplitting(const numerics::Polynomial& potential, std::vector<double> thresholds,
                      double largest_energy);

  double branch_weight(const Branch& branch) const {
    return weights_[static_cast<std::size_t>(std::popcount(branch.split))];
  }
  int threshold_count() const { return static_cast<int>(thresholds_.size()); }
  const std::vector<double>& thresholds() const { return thresholds_; }
  const BinFinder& energy_bins() const { return energy_bins_; }

  /// After an impulse, splits the branch of the stream, or ends this branch and resumes the next
  /// pending branch.
  void update_after_impulse(Stream& stream) const;
  /// Splits the initial state of a stream at the thresholds below its energy.
  void split_initial_state(Stream& stream) const;

 private:
  double energy(const Branch& branch) const;
  int energy_level(double energy) const;
  bool may_split(const StreamRecord& record) const;
  void split(Stream& stream, int from, bool at_impulse) const;

  numerics::Polynomial potential_;
  std::vector<double> thresholds_;
  std::vector<double> weights_;
  BinFinder energy_bins_;
};

/// Resumes the next pending branch of a stream.
/// @pre the stream has a pending branch
void resume_next_branch(Stream& stream);

/// Threshold energies whose exceedance probabilities have a ratio of about 1/kCopies from one
/// threshold to the next. About a fraction `rarest` of the states after impulses exceeds the last
/// threshold.
/// @param energies weights of the states after impulses in each energy bin, summed over all streams
std::vector<double> choose_thresholds(const BinFinder& bins, const std::vector<double>& energies,
                                      double fewest_visits, double rarest);

}  // namespace fpkcheck::mcs
