#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

/// The motion averaged over its undamped orbits (Stratonovich; Freidlin and Wentzell on the tree of
/// the orbits of several wells): with h = v^2/2 + V(y), V = U - lambda E[Y] y, the stationary density
/// is about exp(-Phi(h)),
///
///     dPhi/dh = (closed integral of f dy + sum over walls hit of (1 - r^2) u^2 / 2)
///               / (D_eff closed integral of v dy),     D_eff = D + lambda E[Y^2] / 2,
///
/// for wells and for rings (limit cycles); exact for white noise and r = 1 where f depends on the
/// energy alone.
class EnergyAveraging {
 public:
  /// @pre the spring holds: UndampedOrbits::confined()
  explicit EnergyAveraging(const Problem& problem);

  const UndampedOrbits& orbits() const { return orbits_; }

  /// Nothing where Phi does not grow at the largest energies: why, in one phrase.
  const std::optional<std::string>& unconfined() const { return unconfined_; }

  /// Orbits in a band of energies and what share of the time the motion spends on them.
  struct Band {
    double energy;  ///< of its middle
    Orbit orbit;
    double potential;   ///< Phi, 0 at the least
    double mass = 0;    ///< they sum to 1
    std::size_t above;  ///< index of the band that it merges into; its own at the top
  };
  /// Sorted by energy. @pre confined
  const std::vector<Band>& bands() const { return bands_; }

  /// The eigenvalue next to 0 of the averaged diffusion, per unit time: how the slowest deviation of
  /// the energy, or of the masses of the wells, decays. @pre confined
  double relaxation() const;

 private:
  double slope(const Orbit& orbit) const;
  /// Energies between which Phi is within kDepth of its least.
  bool find_range(double& low, double& high);
  void fill(double low, double high);

  UndampedOrbits orbits_;
  double diffusion_;  // D_eff
  std::optional<std::string> unconfined_;
  std::vector<Band> bands_;
  double step_ = 0;
};

}  // namespace fpkcheck::problem
