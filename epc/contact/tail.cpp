#include "epc/contact/tail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "epc/amplitude/half_circle.hpp"

namespace fpkcheck::epc::contact {

half_plane::Contour contour(const Coordinates& coordinates, double rho) {
  // The area A inside the contour has dA/dh = integral of w/g dtheta.
  half_plane::Contour contour;
  for (int k = 0; k < amplitude::kPhaseCount; ++k) {
    const double theta = amplitude::phases()[k];
    const double w = rho * std::cos(theta), v = rho * std::sin(theta), y = coordinates.y(w);
    contour.push_back({.s = rho,
                       .t = v,
                       .y = y,
                       .v = v,
                       .area = amplitude::phase_weight(k) * w / coordinates.force(y) *
                               Coordinates::prefactor(rho)});
  }
  return contour;
}

LeadingForm leading_form_of(const Polynomial& q, const Deviations& sigma) {
  LeadingForm form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0;
  std::vector<double> worst;
  for (const double theta : amplitude::phases()) {
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
  const std::vector<double> slope = derivative(worst);
  double radius = kLargestRadius;
  while (radius > 0 && horner(slope, radius * sigma.x2) > 0) radius -= 0.05;
  form.rises_from = std::max(radius, 0.0);
  return form;
}

}  // namespace fpkcheck::epc::contact
