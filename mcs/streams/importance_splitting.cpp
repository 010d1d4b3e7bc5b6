#include "mcs/streams/importance_splitting.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

namespace fpkcheck::mcs {
namespace {

/// Returns the edges of energy bins over eight decades up to `largest`; each bin is 2 % wider than
/// the bin below.
std::vector<double> energy_edges(double largest) {
  constexpr int kBins = 930;
  std::vector<double> edges;
  for (int k = kBins; k >= 0; --k) edges.push_back(largest * std::pow(1.02, -k));
  return edges;
}

/// Returns a value of TrajectoryBranch::split in which the bits of the thresholds first + 1 .. last
/// are set.
std::uint64_t threshold_bits(int first, int last) {
  return (std::uint64_t{1} << last) - (std::uint64_t{1} << first);
}

}  // namespace

ImportanceSplitting::ImportanceSplitting(const numerics::Polynomial& potential,
                                         std::vector<double> thresholds, double largest_energy)
    : potential_(potential),
      thresholds_(std::move(thresholds)),
      energy_bins_(energy_edges(largest_energy)) {
  if (thresholds_.size() > kMaxEnergyThresholds) thresholds_.resize(kMaxEnergyThresholds);
  for (std::size_t i = 0; i <= thresholds_.size(); ++i) {
    weights_.push_back(std::pow(kCopiesPerSplit, -static_cast<double>(i)));
  }
}

double ImportanceSplitting::branch_energy(const TrajectoryBranch& b) const {
  return b.v * b.v / 2 + potential_(b.y);
}

int ImportanceSplitting::energy_level(double energy) const {
  return static_cast<int>(std::ranges::upper_bound(thresholds_, energy) - thresholds_.begin());
}

bool ImportanceSplitting::may_split_branch(const TrajectoryStreamStatistics& record) const {
  const auto most = static_cast<std::uint64_t>(kBranchImpulsesPerThreshold * threshold_count());
  return record.branch_impulses < kBranchImpulseAllowance + most * record.impulses;
}

void ImportanceSplitting::split_branch(TrajectoryStream& stream, int from, bool at_impulse) const {
  const int to = stream.branch.energy_level, first = std::max(from, to - kMaxSplitsPerBranch);
  if (!may_split_branch(stream.record)) return;
  stream.branch.split |= threshold_bits(first, to);
  const TrajectoryBranch origin = stream.branch;
  stream.pending_branches.push_back({.branch = origin});
  // Each energy threshold that an impulse crosses splits each of the present branches into
  // kCopiesPerSplit branches.
  int branches = 1;
  for (int i = first; i < to; ++i) {
    TrajectoryBranch copy = origin;
    copy.floor_level = i + 1;
    stream.pending_branches.push_back(
        {.branch = copy, .copies = branches * (kCopiesPerSplit - 1), .at_impulse = at_impulse});
    branches *= kCopiesPerSplit;
  }
  resume_pending_branch(stream);
}

void ImportanceSplitting::split_or_end_branch_by_energy(TrajectoryStream& stream) const {
  TrajectoryBranch& branch = stream.branch;
  const double now = branch_energy(branch);
  const int before = branch.energy_level;
  branch.energy_level = energy_level(now);
  branch.split &= threshold_bits(0, branch.energy_level);
  // The state after an impulse is counted before the trajectory is split, since each copy would
  // count the state again.
  stream.record.energies[energy_bins_(now)] += branch_statistical_weight(branch);
  if (branch.energy_level > before) {
    split_branch(stream, before, true);
  } else if (branch.energy_level < branch.floor_level) {
    resume_pending_branch(stream);
  }
}

void ImportanceSplitting::split_initial_state(TrajectoryStream& stream) const {
  stream.record.energies.resize(energy_bins_.bin_count() + 2);
  stream.branch.energy_level = energy_level(branch_energy(stream.branch));
  stream.branch.floor_level = 0;
  stream.branch.split = 0;
  if (stream.branch.energy_level > 0) split_branch(stream, 0, false);
}

void resume_pending_branch(TrajectoryStream& stream) {
  assert(!stream.pending_branches.empty());
  PendingTrajectoryBranch& next = stream.pending_branches.back();
  stream.branch = next.branch;
  if (next.copies > 0) {
    const Impulse impulse = stream.source.next_impulse();
    // Copies of a trajectory from a split between impulses share the time of the next impulse but
    // draw different amplitudes.
    if (next.at_impulse) stream.branch.time_to_impulse = impulse.waiting_time;
    stream.branch.amplitude = impulse.amplitude;
    --next.copies;
  }
  if (next.copies == 0) stream.pending_branches.pop_back();
}

std::vector<double> choose_energy_thresholds(const BinFinder& bins,
                                             const std::vector<double>& energies,
                                             double fewest_visits,
                                             double smallest_exceedance_probability) {
  double total = 0;
  for (const double weight : energies) total += weight;
  std::vector<double> thresholds;
  double above = total, next = total / ImportanceSplitting::kCopiesPerSplit;
  for (std::size_t b = 0; b + 1 < energies.size() &&
                          next >= std::max(fewest_visits, smallest_exceedance_probability * total);
       ++b) {
    above -= energies[b];
    if (above > next) continue;
    thresholds.push_back(bins.edges()[b]);
    while (next >= above) next /= ImportanceSplitting::kCopiesPerSplit;
  }
  return thresholds;
}

}  // namespace fpkcheck::mcs
