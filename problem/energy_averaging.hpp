#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

/// Energy averaging: the motion averaged over its undamped orbits (Stratonovich; Freidlin and
/// Wentzell on the tree of orbits of several wells). With h = v^2/2 + V(y), V = U - lambda E[Y] y,
/// the stationary density is approximately exp(-Phi(h)),
///
///     dPhi/dh = (closed integral of f dy + sum over walls hit of (1 - r^2) u^2 / 2)
///               / (D_eff closed integral of v dy),     D_eff = D + lambda E[Y^2] / 2,
///
/// for single and multiple wells and for limit cycles. Exact for white noise and r = 1 where f
/// depends on the energy alone.
class EnergyAveraging {
 public:
  /// @pre the potential is confining: UndampedOrbits::is_confining()
  explicit EnergyAveraging(const Problem& problem);

  const UndampedOrbits& orbits() const { return orbits_; }

  /// Empty when Phi grows at the largest energies; otherwise the reason in one phrase why the
  /// motion is not confined.
  const std::optional<std::string>& unconfined_reason() const { return unconfined_reason_; }

  /// The orbits of one well in a band of energies, and the fraction of time spent there.
  struct Band {
    double energy;  ///< at the middle of the band
    Orbit orbit;
    double potential;   ///< Phi, with its minimum 0
    double mass = 0;    ///< probability of the band; the sum is 1
    std::size_t above;  ///< index of the band above in the tree; at the top its own index
  };
  /// Sorted by energy. @pre the motion is confined
  const std::vector<Band>& bands() const { return bands_; }

  /// The smallest positive eigenvalue of the averaged diffusion, per unit time: the decay rate of
  /// the slowest deviation of the energy, or of the probabilities of the wells.
  /// @pre the motion is confined
  double relaxation_rate() const;

 private:
  double slope(const Orbit& orbit) const;
  /// Finds the energies between which Phi is within kDepth of its minimum.
  bool find_range(double& low, double& high);
  void fill_bands(double low, double high);

  UndampedOrbits orbits_;
  double diffusion_;  // D_eff
  std::optional<std::string> unconfined_reason_;
  std::vector<Band> bands_;
  double step_ = 0;
};

}  // namespace fpkcheck::problem
