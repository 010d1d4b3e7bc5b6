#pragma once

#include <cmath>
#include <limits>

namespace fpkcheck::epc::half_plane {

/// A fixed term -(h / level)^kPower that is added to the exponent Q_n, h being an energy: nothing
/// where the density lives, and steeper than any Q_n beyond the level. With it the exponent falls
/// in every direction whatever the leading form of Q_n, so that C exp(Q_n - (h/level)^kPower) is a
/// density on the whole half-plane, and the moment equations hold for it without a cut.
struct Confinement {
  static constexpr int kPower = 16;
  /// Where the term is -kNegligible, in levels: what lies beyond is left out.
  static constexpr double kNegligible = 45;

  double level = std::numeric_limits<double>::infinity();  ///< infinite: no confinement

  /// The term itself, at an energy.
  double operator()(double energy) const {
    return std::isfinite(level) ? -std::pow(energy / level, kPower) : 0;
  }
  /// The energy beyond which nothing counts, in units of the level.
  static double reach() { return std::pow(kNegligible, 1.0 / kPower); }
};

}  // namespace fpkcheck::epc::half_plane
