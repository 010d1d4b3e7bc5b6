#include "epc/form/leading_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::epc {
namespace {

// Removes the terms that are rounding errors and have no reliable sign. In the scaled plane these
// terms are smaller than kRounding times the largest term.
Polynomial without_rounding(const Polynomial& q, const StandardDeviations& sigma) {
  constexpr double kRounding = 1e-10;
  const auto size = [&](const Term& term) {
    return std::abs(term.a) * std::pow(sigma.x1, term.x1) * std::pow(sigma.x2, term.x2);
  };
  double largest = 0;
  for (const Term& term : q.terms()) largest = std::max(largest, size(term));
  std::vector<Term> terms = q.terms();
  std::erase_if(terms, [&](const Term& term) { return size(term) <= kRounding * largest; });
  return Polynomial(std::move(terms));
}

}  // namespace

LeadingForm leading_form(const Polynomial& with_rounding, const StandardDeviations& sigma,
                         DirectionSet plane) {
  const Polynomial q = without_rounding(with_rounding, sigma);
  LeadingForm form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0, seen = 0;
  const std::size_t distinct = distinct_direction_count(q);
  RayCoefficients worst;
  for (std::size_t k = 0; k < scan_directions().size(); ++k) {
    const Direction e = scan_directions()[k];
    if (plane == DirectionSet::half ? e.x1 < 0 : k >= distinct) continue;
    ++seen;
    const RayCoefficients coefficients = restrict_to_ray(q, sigma, e);
    if (coefficients.size() < 2) continue;
    const double leading = coefficients.back();
    if (leading > 0) ++rising;
    if (leading > largest) {
      largest = leading;
      form.worst = e;
      worst = coefficients;
    }
  }
  form.negative = rising == 0;
  form.rising_fraction = static_cast<double>(rising) / seen;
  if (!form.negative) {
    // Q_n rises from the last change of sign of the slope on. The scan ends at 4 kLargestRadius.
    const RayCoefficients slope = derivative_coefficients(worst);
    double rho = 4 * kLargestRadius;
    while (rho > 0 && horner(slope, rho) > 0) rho -= kRadialStep / 8;
    form.rises_from = std::max(rho, 0.0);
  }
  return form;
}

std::string leading_form_text(const LeadingForm& form, const std::string& plane) {
  if (form.negative) return "although Q_n falls at infinity";
  return fmt::format(
      "and Q_n rises at infinity along {:.0f} % of all directions, most steeply along {} = "
      "({:.2f}, {:.2f}) from radius {:.2f} on",
      100 * form.rising_fraction, plane, form.worst.x1, form.worst.x2, form.rises_from);
}

}  // namespace fpkcheck::epc
