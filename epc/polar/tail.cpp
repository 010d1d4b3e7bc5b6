#include "epc/polar/tail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fpkcheck::epc::polar {
namespace {

constexpr int kPhases = 33;

template <class Visit>
void along_phases(const Visit& visit) {
  for (int i = 0; i < kPhases; ++i) visit(std::numbers::pi * (i / (kPhases - 1.0) - 0.5));
}

}  // namespace

double largest_at(const Polynomial& q, double rho) {
  double largest = -std::numeric_limits<double>::infinity();
  along_phases([&](double theta) { largest = std::max(largest, q(rho, theta)); });
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

double probability_beyond(const Polynomial& q, const Coordinates& coordinates, double rho,
                          double temperature, double log_normalisation) {
  // dA/dh is the integral of dtheta / w'(y).
  double density = 0;
  along_phases([&](double theta) {
    const double slope = coordinates.slope(coordinates.y(rho * std::cos(theta)));
    const double share = std::abs(std::abs(theta) - std::numbers::pi / 2) < 1e-9 ? 0.5 : 1;
    density += share * std::exp(q(rho, theta) - log_normalisation) / slope * std::numbers::pi /
               (kPhases - 1);
  });
  return temperature * density;
}

std::pair<double, double> radii(const Coordinates& coordinates, double rho,
                                const Deviations& sigma) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  along_phases([&](double theta) {
    const double y = coordinates.y(rho * std::cos(theta)), v = rho * std::sin(theta);
    const double radius = std::hypot(y / sigma.x1, v / sigma.x2);
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
  });
  return {least, greatest};
}

LeadingForm leading_form(const Polynomial& q, const Deviations& sigma) {
  const int degree = q.degree();
  const auto highest = std::ranges::find_if(
      q.terms(), [&](const Term& term) { return term.x1 == degree && term.x2 == 0; });
  LeadingForm form{highest != q.terms().end() && highest->a < 0, {1, 0}, 0, 0};
  if (form.negative) return form;
  form.rising_share = 1;
  const std::vector<double> slope = derivative(q.along(1, 0));
  double radius = Support::kFarthest;
  while (radius > 0 && horner(slope, radius * sigma.x2) > 0) radius -= 0.05;
  form.rises_from = std::max(radius, 0.0);
  return form;
}

}  // namespace fpkcheck::epc::polar
