#include "epc/contact/contour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "epc/amplitude/half_circle.hpp"

namespace fpkcheck::epc::contact {

half_plane::Contour contour_of_amplitude(const Coordinates& coordinates, double rho) {
  // The area A inside the contour has dA/dh = integral of w/g dtheta.
  half_plane::Contour contour;
  for (int k = 0; k < amplitude::kPhaseCount; ++k) {
    const double theta = amplitude::scan_phases()[k];
    const double w = rho * std::cos(theta), v = rho * std::sin(theta),
                 y = coordinates.displacement(w);
    contour.push_back(
        {.s = rho,
         .t = v,
         .y = y,
         .v = v,
         .area = amplitude::trapezoidal_phase_weight(k) * w / coordinates.restoring_force(y) *
                 Coordinates::density_prefactor(rho)});
  }
  return contour;
}

LeadingForm leading_form_in_amplitude_and_velocity(const Polynomial& q,
                                                   const StandardDeviations& sigma) {
  LeadingForm form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0;
  std::vector<double> worst;
  for (const double theta : amplitude::scan_phases()) {
    const double sine = std::sin(theta);
    const std::vector<double> restriction_to_ray = q.restriction_to_ray(1, sine);
    if (restriction_to_ray.back() > 0) ++rising;
    if (restriction_to_ray.back() <= largest) continue;
    largest = restriction_to_ray.back();
    form.worst = {1, sine};
    worst = restriction_to_ray;
  }
  form.negative = rising == 0;
  form.rising_fraction = static_cast<double>(rising) / amplitude::kPhaseCount;
  if (form.negative) return form;
  const std::vector<double> slope = derivative_coefficients(worst);
  double radius = kLargestRadius;
  while (radius > 0 && horner(slope, radius * sigma.x2) > 0) radius -= 0.05;
  form.rises_from = std::max(radius, 0.0);
  return form;
}

}  // namespace fpkcheck::epc::contact
