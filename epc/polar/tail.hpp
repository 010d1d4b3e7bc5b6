#pragma once

#include "epc/form/leading_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::epc::polar {

/// Quadrature points on the half-circle of an amplitude.
half_plane::Contour contour(const Coordinates& coordinates, double rho);

/// Condition (19) for a polynomial of rho and theta. The coefficient of its highest power of rho is
/// constant: the polynomial falls at every phase or at none. Radii are rho/sigma_2.
LeadingForm leading_form_in_amplitude(const Polynomial& q, const Deviations& sigma);

}  // namespace fpkcheck::epc::polar
