#include "epc/half_plane/closure_density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::epc::half_plane {

double support_energy(double level, DensityTailTreatment tail) {
  return tail == DensityTailTreatment::confined
             ? level * ExponentConfinementTerm::support_to_level_ratio()
             : level;
}

ExponentConfinementTerm make_exponent_confinement(double level, DensityTailTreatment tail) {
  return tail == DensityTailTreatment::confined ? ExponentConfinementTerm{level}
                                                : ExponentConfinementTerm{};
}

std::pair<double, double> scaled_radius_range(const DensityContour& contour,
                                              const StandardDeviations& sigma) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const DensityContourPoint& point : contour) {
    const double radius = std::hypot(point.y / sigma.x1, point.v / sigma.x2);
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
  }
  return {least, greatest};
}

double probability_beyond_contour(const ExponentPolynomial& q, const DensityContour& contour,
                                  double temperature, double log_normalisation) {
  double density = 0;
  for (const DensityContourPoint& point : contour) {
    density += std::exp(q(point.s, point.t) - log_normalisation) * point.area;
  }
  return temperature * density;
}

}  // namespace fpkcheck::epc::half_plane
