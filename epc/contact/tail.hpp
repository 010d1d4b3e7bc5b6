#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/form/leading_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"

namespace fpkcheck::epc::contact {

/// Quadrature points on the half-circle of an amplitude. Their areas include the factor 1/e.
half_plane::Contour contour(const Coordinates& coordinates, double rho);

/// Condition (19) for a polynomial of rho and v, in the directions v = rho sin(theta). Radii are
/// rho/sigma_2.
LeadingForm leading_form_of(const Polynomial& q, const Deviations& sigma);

}  // namespace fpkcheck::epc::contact
