#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

/// Energy averaging: damping and excitation are averaged over the undamped orbits (Stratonovich;
/// for several wells Freidlin and Wentzell, on the tree of orbits). With h = v^2/2 + V(y) and V = U
/// - lambda E[Y] y, the stationary density is approximately exp(-Phi(h)), where
///
///     dPhi/dh = (closed integral of f dy + sum over walls hit of (1 - r^2) u^2 / 2)
///               / (D_eff closed integral of v dy),     D_eff = D + lambda E[Y^2] / 2,
///
/// The method applies to single and multiple wells and to limit cycles. The density is exact for
/// white noise and r = 1 where f depends on the energy alone.
class EnergyAveraging {
 public:
  /// @pre the potential is confining: UndampedOrbits::is_confining()
  explicit EnergyAveraging(const Problem& problem);

  const UndampedOrbits& orbits() const { return orbits_; }

  /// The reason, in one phrase, why the motion is not confined. Empty if Phi increases at the
  /// largest energies, that is, if the motion is confined.
  const std::optional<std::string>& unconfined_reason() const { return unconfined_reason_; }

  /// A band: the undamped orbits of one well in an interval of energies, with the stationary
  /// probability of these orbits.
  struct EnergyBand {
    double energy;  ///< energy at the middle of the band
    OrbitIntegrals orbit;
    double potential;   ///< Phi, shifted such that its minimum is 0
    double mass = 0;    ///< probability of the band; the probabilities of all bands have the sum 1
    std::size_t above;  ///< index of the band above in the tree; for the top band its own index
  };
  /// All bands, sorted by energy. @pre the motion is confined
  const std::vector<EnergyBand>& bands() const { return bands_; }

  /// The smallest positive eigenvalue of the averaged diffusion of the energy, per unit time. This
  /// is the decay rate of the slowest deviation from the stationary law: a deviation of the energy,
  /// or of the probabilities of the wells.
  /// @pre the motion is confined
  double relaxation_rate() const;

 private:
  double slope(const OrbitIntegrals& orbit) const;
  /// Finds the interval of energies in which Phi exceeds its minimum by at most kDepth.
  /// @return false if the motion is not confined
  bool find_energy_range(double& low, double& high);
  void compute_bands(double low, double high);

  UndampedOrbits orbits_;
  double diffusion_;  // D_eff
  std::optional<std::string> unconfined_reason_;
  std::vector<EnergyBand> bands_;
  double step_ = 0;
};

}  // namespace fpkcheck::problem
