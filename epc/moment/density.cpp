#include "epc/moment/density.hpp"

#include <cmath>

namespace fpkcheck::epc::moment {

transform::SmoothDensity density_from_exponent(const Polynomial& q, const EnergyDomain& domain,
                                               const half_plane::Confinement& confinement,
                                               double log_constant) {
  return {.value =
              [q, domain, confinement, log_constant](double y, double v) {
                if (!domain.contains(y, v)) return 0.0;
                return std::exp(q(y, v) + confinement(domain.energy(y, v)) + log_constant);
              },
          .y_max = domain.y_max(),
          .v_max = domain.v_max(),
          .y_min = domain.y_min()};
}

}  // namespace fpkcheck::epc::moment
