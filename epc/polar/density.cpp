#include "epc/polar/density.hpp"

#include <cmath>

#include "epc/amplitude/half_circle.hpp"

namespace fpkcheck::epc::polar {

transform::SmoothDensity density_of(const Polynomial& q, const Coordinates& coordinates,
                                    double support, const half_plane::Confinement& confinement,
                                    double log_constant) {
  const double largest = amplitude::amplitude_at(support);
  return {.value =
              [q, coordinates, largest, confinement, log_constant](double y, double v) {
                const double rho = coordinates.rho(y, v);
                if (y < 0 || rho > largest) return 0.0;
                return std::exp(q(rho, coordinates.theta(y, v)) +
                                confinement(amplitude::energy_at(rho)) + log_constant);
              },
          .y_max = coordinates.y(largest),
          .v_max = largest};
}

}  // namespace fpkcheck::epc::polar
