#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "epc/form/exponent_polynomial.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::half_plane {

/// Confinement term -(h / level)^kPower, a function of the energy h that is added to the exponent
/// Q_n. The confinement term is negligible where the density is large, and falls faster than every
/// polynomial Q_n rises at energies above the confinement level. Therefore C exp(Q_n -
/// (h/level)^kPower), with the energy h, is a density on the whole half-plane, and satisfies the
/// moment equations without a cut-off of the density.
struct ExponentConfinementTerm {
  static constexpr int kPower = 16;
  /// The closure density is neglected where the confinement term is below -kNegligible.
  static constexpr double kNegligible = 45;

  /// Confinement level of the density, an energy; infinite without confinement
  double level = std::numeric_limits<double>::infinity();

  double operator()(double energy) const {
    return std::isfinite(level) ? -std::pow(energy / level, kPower) : 0;
  }
  /// Ratio of the energy above which the closure density is neglected to the confinement level.
  static double support_to_level_ratio() { return std::pow(kNegligible, 1.0 / kPower); }
};

/// Returns the energy above which a closure density with the given confinement level is 0.
double support_energy(double level, DensityTailTreatment tail);

/// Returns the confinement term with the given level; without confinement for
/// DensityTailTreatment::cut.
ExponentConfinementTerm make_exponent_confinement(double level, DensityTailTreatment tail);

/// Closure density C exp(Q_n + confinement term), with its scales and limits.
struct ClosureDensity {
  ExponentPolynomial q{{}};      ///< polynomial Q_n of s and t, without the constant term
  double temperature = 0;        ///< mean square velocity E[v^2]
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest value of the exponent of the density
  double level = 0;              ///< confinement level, or energy beyond which the density is cut
  double support = 0;            ///< energy beyond which the density is 0
  /// Largest value of the first coordinate s (y or amplitude) up to which the exponent Q_n falls.
  double end_of_exponent_decay = std::numeric_limits<double>::infinity();
};

struct DensityContourPoint {
  double s, t;
  double y, v;
  double area;  ///< contribution of the point to dA/dh, where A is the area inside the contour
};
using DensityContour = std::vector<DensityContourPoint>;

/// Returns the smallest and the largest distance of a contour from the origin, in standard
/// deviations of the coordinates.
std::pair<double, double> scaled_radius_range(const DensityContour& contour,
                                              const StandardDeviations& sigma);

/// Estimates the probability outside a contour by T oint p dA/dh, which is exact for a density that
/// decays like exp(-h/T).
/// @param temperature temperature T of the decay exp(-h/T)
/// @param log_normalisation ln of the integral of exp(Q_n + confinement term)
double probability_beyond_contour(const ExponentPolynomial& q, const DensityContour& contour,
                                  double temperature, double log_normalisation);

}  // namespace fpkcheck::epc::half_plane
