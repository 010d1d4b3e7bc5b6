#pragma once

#include "epc/form/leading_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::epc::polar {

/// Contour of an amplitude: points on the half-circle of this amplitude.
half_plane::Contour contour_of_amplitude(const Coordinates& coordinates, double rho);

/// Behaviour at infinity of a polynomial of rho and theta, by condition (19) of the paper. The
/// coefficient of the highest power of rho does not depend on theta. Therefore the polynomial falls
/// either at every phase or at no phase. The radii in the result are rho/sigma_2.
LeadingForm leading_form_in_amplitude(const Polynomial& q, const StandardDeviations& sigma);

}  // namespace fpkcheck::epc::polar
