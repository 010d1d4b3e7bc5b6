#pragma once

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/confinement.hpp"
#include "epc/moment/energy_domain.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::moment {

/// Density C exp(Q_n + confinement), where Q_n is a polynomial of y and v; 0 outside of the domain.
transform::SmoothDensity density_from_exponent(const Polynomial& q, const EnergyDomain& domain,
                                               const half_plane::Confinement& confinement,
                                               double log_constant);

}  // namespace fpkcheck::epc::moment
