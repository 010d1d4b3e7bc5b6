#pragma once

#include <cmath>
#include <limits>

namespace fpkcheck::epc::half_plane {

/// Confinement of the density: a fixed term -(h / level)^kPower that is added to the exponent Q_n,
/// where h is the energy. The term is negligible in the bulk of the density, and steeper than any
/// Q_n at energies beyond the level. With this term the exponent falls in every direction for every
/// leading form of Q_n. Therefore C exp(Q_n - (h/level)^kPower) is a density on the whole
/// half-plane, and satisfies the moment equations without a cut.
struct Confinement {
  static constexpr int kPower = 16;
  /// The density is neglected at energies where the term is below -kNegligible.
  static constexpr double kNegligible = 45;

  /// confinement level, an energy; infinite if there is no confinement
  double level = std::numeric_limits<double>::infinity();

  /// Value of the confinement term at an energy.
  double operator()(double energy) const {
    return std::isfinite(level) ? -std::pow(energy / level, kPower) : 0;
  }
  /// Energy beyond which the density is neglected, divided by the confinement level.
  static double support_ratio() { return std::pow(kNegligible, 1.0 / kPower); }
};

}  // namespace fpkcheck::epc::half_plane
