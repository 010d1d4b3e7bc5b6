#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

/// Returns the slope dPhi/dh of the exponent in the averaged density exp(-Phi(h)) of the energy h,
/// from the energy loss and the diffusion of one orbit; 0 without diffusion.
inline double energy_exponent_slope(const OrbitIntegrals& orbit) {
  return orbit.diffusion > 0 ? orbit.loss / orbit.diffusion : 0;
}

/// Energy averaging of damping and excitation over the undamped orbits (Stratonovich). For several
/// potential wells the energy averaging uses the tree of orbits of Freidlin and Wentzell. With the
/// energy h = v^2/2 + V(y) and the effective potential V = U - lambda E[Y] y, the stationary density
/// is approximately exp(-Phi(h)), where
///
///     dPhi/dh = (closed integral of (f + D G_v) dy + sum over walls hit of (1 - r^2) u^2 / 2)
///               / closed integral of (D G + lambda E[Y^2]/2) v dy.
///
/// In the slope dPhi/dh, G = g^2 is the square of the noise factor g, u is the speed of an impact,
/// and f is the damping force of the equation in Ito's sense.
///
/// Energy averaging applies to single and multiple potential wells and to limit cycles. The density
/// exp(-Phi(h)) is exact for white noise and the restitution coefficient r = 1 if f/v and G depend
/// on the energy alone.
class EnergyAveraging {
 public:
  /// @param band_count number of intervals of the energy, which have equal widths
  /// @pre the potential is confining: UndampedOrbits::is_confining()
  explicit EnergyAveraging(const Problem& problem, int band_count = 300);

  const UndampedOrbits& undamped_orbits() const { return orbits_; }

  /// Returns the reason, in one phrase, why the motion is not confined. The reason is empty for
  /// confined motion, for which the exponent Phi(h) increases at the largest energies h.
  const std::optional<std::string>& reason_for_unconfined_motion() const {
    return reason_for_unconfined_motion_;
  }

  /// The undamped orbits of one well in an interval of energies, with their probability.
  struct EnergyBand {
    double energy;  ///< energy at the middle of the band
    OrbitIntegrals orbit;
    /// Negative logarithm Phi of the density at the energy of the band, shifted such that the
    /// minimum of Phi over all bands is 0.
    double potential;
    double mass = 0;  ///< probability of the band; the probabilities of all bands have the sum 1
    /// Index of the next energy band above the present band in the tree of orbits; the parent of
    /// the top band is the top band.
    std::size_t parent;
  };
  /// Returns all energy bands, sorted by energy.
  /// @pre the motion is confined
  const std::vector<EnergyBand>& energy_bands() const {
    assert(!reason_for_unconfined_motion_);
    return bands_;
  }

  /// Returns the smallest positive eigenvalue of the averaged diffusion of the energy, per unit
  /// time. The smallest positive eigenvalue is the decay rate of the slowest deviation from the
  /// stationary probabilities of energies and potential wells.
  /// @pre the motion is confined
  double relaxation_rate() const;

 private:
  /// Finds the interval of energies h in which the exponent Phi(h) of the density exp(-Phi(h))
  /// exceeds the minimum of Phi by at most kDepth.
  /// @return false if the motion is not confined
  bool find_energy_range(double& low, double& high);
  void compute_energy_bands(double lowest, double highest, int band_count);

  UndampedOrbits orbits_;
  std::optional<std::string> reason_for_unconfined_motion_;
  std::vector<EnergyBand> bands_;
  double step_ = 0;  // width of an energy band
};

/// The discretised diffusion of the energy: the nodes are energies on the families of undamped
/// orbits, which form a tree if the potential has several wells. Each node exchanges probability
/// with its parent node, which has a larger index than the node.
struct EnergyDiffusionTree {
  std::vector<double> mass;         ///< stationary probabilities of the nodes, with the sum 1
  std::vector<double> conductance;  ///< conductance between each node and its parent node
  std::vector<std::size_t>
      parent;  ///< index of the parent of each node; for the root its own index
};

/// Returns the smallest positive eigenvalue gamma of K u = gamma M u, the decay rate of the slowest
/// deviation from the stationary probabilities. The diagonal matrix M has the probabilities of the
/// nodes, and the matrix K is the weighted graph Laplacian of the conductances between the nodes.
/// The kernel of the graph Laplacian K consists of the constant vectors, which the inverse
/// iteration projects out.
/// @param initial_vector one value per node, from which the inverse iteration starts
double slowest_relaxation_rate(const EnergyDiffusionTree& tree, std::vector<double> initial_vector);

}  // namespace fpkcheck::problem
