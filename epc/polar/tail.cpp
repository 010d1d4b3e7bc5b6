#include "epc/polar/tail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::polar {
namespace {

// Evenly over the half-circle, its ends on the wall among them.
constexpr int kPhases = 33;
const std::array<double, kPhases>& phases() {
  static const auto list = [] {
    std::array<double, kPhases> angles{};
    for (int i = 0; i < kPhases; ++i) angles[i] = std::numbers::pi * (i / (kPhases - 1.0) - 0.5);
    return angles;
  }();
  return list;
}

}  // namespace

half_plane::Contour contour(const Coordinates& coordinates, double rho) {
  // dA/dh is the integral of dtheta / w'(y), here by the trapezoidal rule.
  constexpr double kStep = std::numbers::pi / (kPhases - 1);
  half_plane::Contour contour;
  for (const double theta : phases()) {
    const bool end = theta == phases().front() || theta == phases().back();
    const double y = coordinates.y(rho * std::cos(theta)), v = rho * std::sin(theta);
    contour.push_back({.s = rho,
                       .t = theta,
                       .y = y,
                       .v = v,
                       .area = (end ? 0.5 : 1) * kStep / coordinates.slope(y)});
  }
  return contour;
}

double largest_at(const Polynomial& q, double rho) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double theta : phases()) largest = std::max(largest, q(rho, theta));
  return largest;
}

Fall fall_of(const Polynomial& q, double depth, double farthest) {
  constexpr int kSteps = 400;
  constexpr double kInside = 5;  // ups and downs above this depth are the density's own
  double peak = largest_at(q, 0), before = peak;
  for (int i = 1; i <= kSteps; ++i) {
    const double rho = farthest * i / kSteps;
    const double largest = largest_at(q, rho);
    peak = std::max(peak, largest);
    if (largest < peak - depth) return {rho, farthest};
    if (largest > before && before < peak - kInside) return {{}, farthest * (i - 1) / kSteps};
    before = largest;
  }
  return {{}, farthest};
}

LeadingForm leading_form_in_amplitude(const Polynomial& q, const Deviations& sigma) {
  const int degree = q.degree();
  const auto highest = std::ranges::find_if(
      q.terms(), [&](const Term& term) { return term.x1 == degree && term.x2 == 0; });
  LeadingForm form{highest != q.terms().end() && highest->a < 0, {1, 0}, 0, 0};
  if (form.negative) return form;
  form.rising_share = 1;
  const std::vector<double> slope = derivative(q.along(1, 0));
  double radius = kFarthest;
  while (radius > 0 && horner(slope, radius * sigma.x2) > 0) radius -= 0.05;
  form.rises_from = std::max(radius, 0.0);
  return form;
}

}  // namespace fpkcheck::epc::polar
