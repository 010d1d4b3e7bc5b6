#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "mcs/streams/trajectory_stream.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::mcs {

/// Importance splitting by RESTART (Villen-Altamirano, ITC 13, 1991), applied to the states right
/// after impulses. The method assumes that the energy E = v^2/2 + V(y) rises only at impulses. An
/// energy that also rises between impulses leaves the estimate unbiased, but splitting then does
/// not increase the number of visits to the tails.
///
/// The branches of a trajectory stream are the main trajectory and the copies that splits make. A
/// branch whose energy rises above a threshold is split into `kCopiesPerSplit` branches with
/// independent random numbers. Of the split branches, kCopiesPerSplit - 1 branches end when the
/// energy falls below the threshold. A branch that was split at n thresholds during the rise of the
/// energy has the weight kCopiesPerSplit^-n. With a split at every threshold, trajectories visit
/// the tails of the density as often as the centre.
///
/// Some splits are omitted, which leaves the estimate unbiased: the decision to split depends only
/// on the past, and copies use new random numbers. Three rules limit memory and time:
/// - An impulse across many thresholds splits only at the highest kMaxSplitsPerBranch thresholds,
///   into 4^3 = 64 branches. Without this rule, one exponential amplitude across 12 thresholds
///   would make 4^12 branches.
/// - Pending branches with the same state share one entry. A stream with L thresholds has at most L
///   (L + 3)/2 entries, since the entries have increasing values of floor_level.
/// - A stream does not split while its other branches have received more than
///   kBranchImpulseAllowance + kBranchImpulsesPerThreshold * L * (impulses of the main branch)
///   impulses. This limit affects only badly spaced thresholds: with the probability ratio
///   1/kCopiesPerSplit between thresholds, the other branches receive about L times as many
///   impulses as the main branch.
class ImportanceSplitting {
 public:
  static constexpr int kCopiesPerSplit = 4;
  static constexpr int kMaxSplitsPerBranch = 3;
  static constexpr int kMaxEnergyThresholds = 32;
  static constexpr int kBranchImpulsesPerThreshold = 4;
  static constexpr std::uint64_t kBranchImpulseAllowance = 1000;

  /// @param potential potential energy V, with minimum 0
  /// @param thresholds increasing energies; may be empty; at most kMaxEnergyThresholds are used
  /// @param largest_energy upper end of the energy bins
  ImportanceSplitting(const numerics::Polynomial& potential, std::vector<double> thresholds,
                      double largest_energy);

  double branch_statistical_weight(const TrajectoryBranch& branch) const {
    return weights_[static_cast<std::size_t>(std::popcount(branch.split))];
  }
  int threshold_count() const { return static_cast<int>(thresholds_.size()); }
  const std::vector<double>& thresholds() const { return thresholds_; }
  const BinFinder& energy_bins() const { return energy_bins_; }

  /// Splits the current trajectory branch if its energy crossed a splitting threshold at an
  /// impulse. Ends the current trajectory branch if its energy fell below the floor level.
  void split_or_end_branch_by_energy(TrajectoryStream& stream) const;
  /// Splits the initial state of a trajectory stream at the thresholds below its energy.
  void split_initial_state(TrajectoryStream& stream) const;

 private:
  double branch_energy(const TrajectoryBranch& branch) const;
  int energy_level(double energy) const;
  bool may_split_branch(const TrajectoryStreamStatistics& record) const;
  void split_branch(TrajectoryStream& stream, int from, bool at_impulse) const;

  numerics::Polynomial potential_;
  std::vector<double> thresholds_;
  std::vector<double> weights_;
  BinFinder energy_bins_;
};

/// Makes the last pending branch of a trajectory stream the current branch.
/// @pre the stream has a pending branch
void resume_pending_branch(TrajectoryStream& stream);

/// Returns threshold energies whose exceedance probability falls by a factor of about
/// kCopiesPerSplit from one threshold to the next, down to about `smallest_exceedance_probability`.
/// @param energies weights of the states after impulses in each energy bin, summed over all streams
/// @param fewest_visits least expected weight of the states above a threshold
std::vector<double> choose_energy_thresholds(const BinFinder& bins,
                                             const std::vector<double>& energies,
                                             double fewest_visits,
                                             double smallest_exceedance_probability);

}  // namespace fpkcheck::mcs
