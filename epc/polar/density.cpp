#include "epc/polar/density.hpp"

#include <cmath>

#include "epc/amplitude/half_circle.hpp"

namespace fpkcheck::epc::polar {

transform::SmoothDensity density_from_exponent(const Polynomial& q, const Coordinates& coordinates,
                                               double support,
                                               const half_plane::Confinement& confinement,
                                               double log_constant) {
  const double largest = amplitude::amplitude_of_energy(support);
  return {.value =
              [q, coordinates, largest, confinement, log_constant](double y, double v) {
                const double rho = coordinates.amplitude_of(y, v);
                if (y < 0 || rho > largest) return 0.0;
                return std::exp(q(rho, coordinates.phase_of(y, v)) +
                                confinement(amplitude::energy_of_amplitude(rho)) + log_constant);
              },
          .y_max = coordinates.displacement(largest),
          .v_max = largest};
}

}  // namespace fpkcheck::epc::polar
