#include "epc/polar/contour.hpp"

#include <algorithm>
#include <cmath>

#include "epc/amplitude/half_circle.hpp"

namespace fpkcheck::epc::polar {
half_plane::Contour contour_of_amplitude(const Coordinates& coordinates, double rho) {
  // The area A inside the contour has dA/dh = integral of dtheta / w'(y).
  half_plane::Contour contour;
  for (int k = 0; k < amplitude::kPhaseCount; ++k) {
    const double theta = amplitude::scan_phases()[k];
    const double y = coordinates.displacement(rho * std::cos(theta)), v = rho * std::sin(theta);
    contour.push_back(
        {.s = rho,
         .t = theta,
         .y = y,
         .v = v,
         .area = amplitude::trapezoidal_phase_weight(k) / coordinates.potential_speed_slope(y)});
  }
  return contour;
}

LeadingForm leading_form_in_amplitude(const Polynomial& q, const StandardDeviations& sigma) {
  const int degree = q.degree();
  const auto highest = std::ranges::find_if(
      q.terms(), [&](const Term& term) { return term.x1 == degree && term.x2 == 0; });
  LeadingForm form{highest != q.terms().end() && highest->a < 0, {1, 0}, 0, 0};
  if (form.negative) return form;
  form.rising_fraction = 1;
  const std::vector<double> slope = derivative_coefficients(q.restriction_to_ray(1, 0));
  double radius = kLargestRadius;
  while (radius > 0 && horner(slope, radius * sigma.x2) > 0) radius -= 0.05;
  form.rises_from = std::max(radius, 0.0);
  return form;
}

}  // namespace fpkcheck::epc::polar
