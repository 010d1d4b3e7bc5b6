#pragma once

#include <vector>

#include "mcs/streams/stream.hpp"
#include "problem/polynomial.hpp"

namespace fpkcheck::mcs {

/// Importance splitting by RESTART (Villen-Altamirano, ITC 13, 1991) on the chain of states right
/// after impulses, where alone the energy rises. (Where something else raised it too there would be
/// no bias, but the tails would not be visited more often for it.)
///
/// A branch whose energy E = v^2/2 + V(y) rises above a threshold becomes `kCopies`
/// branches, which go on with random numbers of their own. All but one end when they fall below the
/// threshold that made them. On level i, between the thresholds i and i + 1, there are kCopies^i
/// branches for one, and what they see counts kCopies^-i: an unbiased estimate of the same time
/// averages, with as many visits to the tails as to the middle.
class Splitting {
 public:
  static constexpr int kCopies = 4;

  /// @param potential V, 0 at the least
  /// @param thresholds increasing energies; may be empty
  /// @param largest_energy of the bins in which energies are counted
  Splitting(const problem::Polynomial& potential, std::vector<double> thresholds,
            double largest_energy);

  double weight(int level) const { return weights_[static_cast<std::size_t>(level)]; }
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
  void split(Stream& stream, int from, bool at_impulse) const;

  problem::Polynomial potential_;
  std::vector<double> thresholds_;
  std::vector<double> weights_;
  BinFinder energy_bins_;
};

/// The next branch in waiting; needs one.
void follow_next(Stream& stream);

/// Thresholds that a branch passes with a probability of about 1/kCopies each, until the energy is
/// exceeded in less than `rarest` of the time after impulses.
/// @param energies weights by energy bins, over all streams
std::vector<double> thresholds_from(const BinFinder& bins, const std::vector<double>& energies,
                                    double fewest_visits, double rarest);

}  // namespace fpkcheck::mcs
