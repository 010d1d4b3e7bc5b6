#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/form/leading_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"

namespace fpkcheck::epc::contact {

/// Contour of an amplitude: points on the half-circle of this amplitude. The areas of the points
/// include the factor 1/e of the density.
half_plane::Contour contour_of_amplitude(const Coordinates& coordinates, double rho);

/// Behaviour at infinity of a polynomial of rho and v, by condition (19) of the paper, in the
/// directions v = rho sin(theta). The radii in the result are rho/sigma_2.
LeadingForm leading_form_in_amplitude_and_velocity(const Polynomial& q,
                                                   const StandardDeviations& sigma);

}  // namespace fpkcheck::epc::contact
