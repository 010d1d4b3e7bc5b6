#include "problem/energy_averaging.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace fpkcheck::problem {
namespace {

// Energies at which the density is below exp(-kDepth) times the largest density are neglected.
constexpr double kDepth = 60;
constexpr const char* kNoDissipation =
    "damping and impacts dissipate no energy at large amplitudes";
// Maximum number of wells of a polynomial potential of degree 6 between two walls.
constexpr std::size_t kMaxBranches = 4;

}  // namespace

EnergyAveraging::EnergyAveraging(const Problem& problem, int band_count) : orbits_(problem) {
  assert(orbits_.is_confining());
  double low = 0, high = 0;
  if (!find_energy_range(low, high)) return;
  compute_energy_bands(low, high, band_count);
  if (bands_.empty())
    reason_for_unconfined_motion_ = "the potential of the force has no resolved levels";
}

// Integrates the slope dPhi/dh, where exp(-Phi(h)) approximates the density of the energy h, from
// the lowest potential upwards in growing steps.
bool EnergyAveraging::find_energy_range(double& low, double& high) {
  constexpr double kSmallest = 1e-40, kLargest = 1e60, kGrowth = 1.25;
  const double bottom = orbits_.lowest_potential();
  const double resolved = std::abs(bottom) * 1e-12;
  struct Level {
    double above, phi;
  };
  // Returns the slope dPhi/dh at a given energy from integrals over all orbits of the given energy;
  // nullopt if no orbit has the given energy.
  const auto slope_at = [&](double above) -> std::optional<double> {
    double loss = 0, diffusion = 0;
    for (const HalfCycle& half_cycle : orbits_.half_cycles(bottom + above)) {
      const OrbitIntegrals orbit = orbits_.orbit_integrals(half_cycle, bottom + above);
      loss += orbit.loss;
      diffusion += orbit.diffusion;
    }
    if (!(diffusion > 0)) return std::nullopt;
    return loss / diffusion;
  };
  std::vector<Level> levels{{0, 0}};
  double least = 0;
  for (double above = kSmallest; above < kLargest; above *= kGrowth) {
    if (above < resolved) continue;
    const auto slope_here = slope_at(above);
    if (!slope_here) continue;
    const double phi = levels.back().phi + *slope_here * (above - levels.back().above);
    if (!std::isfinite(phi)) break;
    levels.push_back({above, phi});
    least = std::min(least, phi);
    if (phi > least + 2 * kDepth) {
      // The slope dPhi/dh is also checked at much larger energies, where a damping term that
      // supplies energy may dominate.
      for (double farther = 1e4 * above; farther < kLargest; farther *= 1e4) {
        if (!(slope_at(farther).value_or(0) < 0)) continue;
        reason_for_unconfined_motion_ = kNoDissipation;
        return false;
      }
      const auto within = [&](const Level& level) { return level.phi <= least + kDepth; };
      const auto first = std::ranges::find_if(levels, within);
      low = bottom + (first == levels.begin() ? 0.0 : std::prev(first)->above);
      // The upper end of the energy range is interpolated within the last step, in which Phi, the
      // negative logarithm of the density, may increase by far more than kDepth.
      const auto last = std::find_if(levels.rbegin(), levels.rend(), within);
      const auto next = std::prev(last);
      const double share = (least + kDepth - last->phi) / (next->phi - last->phi);
      high = bottom + last->above + share * (next->above - last->above);
      return true;
    }
  }
  reason_for_unconfined_motion_ =
      levels.back().phi > least ? "the damping at large energies is too weak to confine the motion"
                                : kNoDissipation;
  return false;
}

void EnergyAveraging::compute_energy_bands(double lowest, double highest, int band_count) {
  step_ = (highest - lowest) / band_count;
  // The energy bands are computed from the largest energy downwards, so that the parent of each
  // energy band in the tree is already known.
  std::vector<EnergyBand> from_top;
  std::size_t upper_begin = 0, upper_end = 0;
  for (int n = band_count - 1; n >= 0; --n) {
    const double energy = lowest + (n + 0.5) * step_;
    const std::size_t begin = from_top.size();
    for (const HalfCycle& half_cycle : orbits_.half_cycles(energy)) {
      EnergyBand band{.energy = energy,
                      .orbit = orbits_.orbit_integrals(half_cycle, energy),
                      .potential = 0,
                      .parent = from_top.size()};
      if (!(band.orbit.period > 0)) continue;
      const double middle = (half_cycle.left + half_cycle.right) / 2;
      for (std::size_t u = upper_begin; u < upper_end; ++u) {
        const HalfCycle& upper = from_top[u].orbit.half_cycle;
        if (middle < upper.left || middle > upper.right) continue;
        band.parent = u;
        band.potential =
            from_top[u].potential -
            step_ * (energy_exponent_slope(band.orbit) + energy_exponent_slope(from_top[u].orbit)) /
                2;
      }
      from_top.push_back(band);
    }
    upper_begin = begin;
    upper_end = from_top.size();
  }
  double least = std::numeric_limits<double>::infinity(), total = 0;
  for (const EnergyBand& band : from_top) least = std::min(least, band.potential);
  for (EnergyBand& band : from_top) {
    band.potential -= least;
    band.mass = band.orbit.period * std::exp(-band.potential);
    total += band.mass;
  }
  for (EnergyBand& band : from_top) {
    band.mass /= total;
    band.parent = from_top.size() - 1 - band.parent;
  }
  bands_.assign(from_top.rbegin(), from_top.rend());
}

// Inverse iteration solves linear equations with the graph Laplacian K by elimination from the
// leaves of the tree, which creates no new nonzeros.
double slowest_relaxation_rate(const EnergyDiffusionTree& tree,
                               std::vector<double> initial_vector) {
  std::vector<double>& u = initial_vector;
  const auto& mass = tree.mass;
  const auto& conductance = tree.conductance;
  const auto& above = tree.parent;  // node above each node of the tree
  const std::size_t n = mass.size();
  const auto centre_and_scale = [&] {
    double mean = 0, square = 0;
    for (std::size_t b = 0; b < n; ++b) mean += mass[b] * u[b];
    for (double& value : u) value -= mean;
    for (std::size_t b = 0; b < n; ++b) square += mass[b] * u[b] * u[b];
    for (double& value : u) value /= std::sqrt(square);
    return std::sqrt(square);
  };
  centre_and_scale();
  double gamma = 0;
  for (int iteration = 0; iteration < 60; ++iteration) {
    // The upward flux from a node equals the sum of the sources below the node, and also minus the
    // sum of all other sources. To reduce rounding errors, the upward flux is computed from the
    // sources on the side of smaller probability.
    std::vector<double> below(n), mass_below(n), elsewhere(n), next(n);
    for (std::size_t b = 0; b < n; ++b) {
      below[b] += mass[b] * u[b];
      mass_below[b] += mass[b];
      if (above[b] == b) continue;
      below[above[b]] += below[b];
      mass_below[above[b]] += mass_below[b];
    }
    for (std::size_t b = n; b-- > 0;) {
      const std::size_t parent = above[b];
      if (parent == b) continue;
      // Sum over the other branches that merge with the branch of node b at the parent node.
      double beside = 0;
      for (std::size_t other = b; other-- > 0 && b - other < kMaxBranches;) {
        if (above[other] == parent) beside += below[other];
      }
      for (std::size_t other = b + 1; other < n && other - b < kMaxBranches; ++other) {
        if (other != parent && above[other] == parent) beside += below[other];
      }
      elsewhere[b] = elsewhere[parent] + mass[parent] * u[parent] + beside;
      const double flux = mass_below[b] < 0.5 ? below[b] : -elsewhere[b];
      next[b] = next[parent] + (conductance[b] > 0 ? flux / conductance[b] : 0);
    }
    u = next;
    const double before = gamma;
    gamma = 1 / centre_and_scale();
    if (std::abs(gamma - before) < 1e-6 * gamma) break;
  }
  return gamma;
}

double EnergyAveraging::relaxation_rate() const {
  assert(!reason_for_unconfined_motion_);
  const std::size_t n = bands_.size();
  EnergyDiffusionTree tree;
  // The normalisation constant of the node probabilities also divides the conductances between the
  // nodes of the tree.
  double unit = 0;
  for (const EnergyBand& band : bands_) unit += band.orbit.period * std::exp(-band.potential);
  std::vector<double> start(n);
  for (std::size_t b = 0; b < n; ++b) {
    const EnergyBand& band = bands_[b];
    const EnergyBand& upper = bands_[band.parent];
    tree.mass.push_back(band.mass);
    tree.parent.push_back(band.parent);
    tree.conductance.push_back((band.orbit.diffusion + upper.orbit.diffusion) / 2 *
                               std::exp(-(band.potential + upper.potential) / 2) / (step_ * step_) /
                               unit);
    start[b] = band.orbit.half_cycle.left + band.energy;
  }
  return slowest_relaxation_rate(tree, std::move(start));
}

}  // namespace fpkcheck::problem
