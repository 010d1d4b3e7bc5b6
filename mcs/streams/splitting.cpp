#include "mcs/streams/splitting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fpkcheck::mcs {
namespace {

/// Bins each 2 % wider than the one before, over eight decades.
std::vector<double> energy_edges(double largest) {
  constexpr int kBins = 930;
  std::vector<double> edges;
  for (int k = kBins; k >= 0; --k) edges.push_back(largest * std::pow(1.02, -k));
  return edges;
}

}  // namespace

Splitting::Splitting(const problem::Polynomial& potential, std::vector<double> thresholds,
                     double largest_energy)
    : potential_(potential),
      thresholds_(std::move(thresholds)),
      energy_bins_(energy_edges(largest_energy)) {
  for (std::size_t i = 0; i <= thresholds_.size(); ++i) {
    weights_.push_back(std::pow(kCopies, -static_cast<double>(i)));
  }
}

double Splitting::energy(const Branch& b) const { return b.v * b.v / 2 + potential_(b.y); }

int Splitting::level(double energy) const {
  return static_cast<int>(std::ranges::upper_bound(thresholds_, energy) - thresholds_.begin());
}

void Splitting::split(Stream& stream, int from, bool at_impulse) const {
  const Branch origin = stream.branch;
  const GeneralBranch general = stream.general;
  stream.waiting.push_back({origin, general});
  // Above threshold i + 1 each of the branches made so far becomes kCopies.
  std::size_t branches = 1;
  for (int i = from; i < origin.level; ++i) {
    for (std::size_t n = 0; n < branches * (kCopies - 1); ++n) {
      Branch copy = origin;
      const Impulse next = stream.source.next();
      if (at_impulse)
        copy.until_impulse = next.waiting;  // else they share the time, not what comes
      copy.amplitude = next.amplitude;
      copy.floor = i + 1;
      stream.waiting.push_back({copy, general});
    }
    branches *= kCopies;
  }
  follow_next(stream);
}

void Splitting::after_impulse(Stream& stream) const {
  Branch& branch = stream.branch;
  const double now = energy(branch);
  const int before = branch.level;
  branch.level = level(now);
  stream.record.energies[energy_bins_(now)] += weight(branch.level);
  if (branch.level > before) {
    split(stream, before, true);
  } else if (branch.level < branch.floor) {
    follow_next(stream);
  }
}

void Splitting::begin(Stream& stream) const {
  stream.record.energies.resize(energy_bins_.bins() + 2);
  stream.branch.level = std::min(level(energy(stream.branch)), levels());
  stream.branch.floor = 0;
  if (stream.branch.level > 0) split(stream, 0, false);
}

void follow_next(Stream& stream) {
  stream.branch = stream.waiting.back().branch;
  stream.general = stream.waiting.back().general;
  stream.waiting.pop_back();
}

std::vector<double> thresholds_from(const BinFinder& bins, const std::vector<double>& energies,
                                    double fewest_visits, double rarest) {
  double total = 0;
  for (const double weight : energies) total += weight;
  std::vector<double> thresholds;
  double above = total, next = total / Splitting::kCopies;
  for (std::size_t b = 0;
       b + 1 < energies.size() && next >= std::max(fewest_visits, rarest * total); ++b) {
    above -= energies[b];
    if (above > next) continue;
    thresholds.push_back(bins.edges()[b]);
    while (next >= above) next /= Splitting::kCopies;
  }
  return thresholds;
}

}  // namespace fpkcheck::mcs
