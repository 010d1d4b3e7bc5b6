#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/options.hpp"

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

/// Energy beyond which a density with a given confinement level is 0.
double support_energy(double level, TailTreatment tail);

/// Confinement with a given level; no confinement for TailTreatment::cut.
Confinement confinement_of(double level, TailTreatment tail);

/// Parameters of the closure's density C exp(Q_n + confinement).
struct ClosureDensity {
  Polynomial q{{}};              ///< Q_n in monomials of s and t, without the constant term
  double temperature = 0;        ///< E[v^2]
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest exponent
  double level = 0;              ///< confinement level, or energy beyond which the density is cut
  double support = 0;            ///< energy beyond which the density is 0
  /// Largest s up to which Q_n falls; Q_n may rise at larger s.
  double decay_extent = std::numeric_limits<double>::infinity();
};

/// Point on the contour of an energy h.
struct ContourPoint {
  double s, t;  ///< coordinates of Q_n, see QuadraturePoints
  double y, v;
  double area;  ///< contribution of the point to dA/dh, where A is the area inside the contour
};
using Contour = std::vector<ContourPoint>;

/// Smallest and largest distance from the origin of the points of a contour, in the plane scaled by
/// sigma.
std::pair<double, double> radius_range(const Contour& contour, const StandardDeviations& sigma);

/// Estimate of the probability outside a contour: T oint p dA/dh. The estimate is exact for a
/// density that decays like exp(-h/T).
/// @param temperature temperature T of this decay
/// @param log_normalisation ln of the integral of the density before its normalisation
double probability_beyond_contour(const Polynomial& q, const Contour& contour, double temperature,
                                  double log_normalisation);

}  // namespace fpkcheck::epc::half_plane
