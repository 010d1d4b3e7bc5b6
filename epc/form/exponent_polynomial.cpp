#include "epc/form/exponent_polynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cassert>
#include <cmath>
#include <limits>

namespace fpkcheck::epc {

ExponentPolynomial::ExponentPolynomial(std::vector<ExponentMonomial> terms)
    : terms_(std::move(terms)), degree_(0) {
  for (const auto& [p, q, a] : terms_) degree_ = std::max(degree_, p + q);
  for (int p = degree_; p >= 0; --p) {
    for (int q = degree_ - p; q >= 0; --q) {
      double coefficient = 0;
      for (const ExponentMonomial& term : terms_) {
        if (term.x1 == p && term.x2 == q) coefficient += term.a;
      }
      triangle_.push_back(coefficient);
    }
  }
}

double ExponentPolynomial::operator()(double x1, double x2) const {
  double value = 0;
  const double* coefficient = triangle_.data();
  for (int p = degree_; p >= 0; --p) {
    double row = 0;
    for (int q = degree_ - p; q >= 0; --q) row = row * x2 + *coefficient++;
    value = value * x1 + row;
  }
  return value;
}

std::vector<double> ExponentPolynomial::coefficients_along_ray(double e1, double e2) const {
  std::vector<double> power1{1}, power2{1};
  for (int m = 1; m <= degree_; ++m) {
    power1.push_back(power1.back() * e1);
    power2.push_back(power2.back() * e2);
  }
  std::vector<double> coefficients(degree_ + 1);
  for (const auto& [p, q, a] : terms_) coefficients[p + q] += a * power1[p] * power2[q];
  return coefficients;
}

std::vector<double> derivative_coefficients(const std::vector<double>& coefficients) {
  std::vector<double> result;
  for (std::size_t m = 1; m < coefficients.size(); ++m) {
    result.push_back(static_cast<double>(m) * coefficients[m]);
  }
  return result;
}

const std::vector<PhasePlaneDirection>& equiangular_directions() {
  constexpr int kDirections = 1440;
  static const std::vector<PhasePlaneDirection> table = [] {
    std::vector<PhasePlaneDirection> all;
    for (int k = 0; k < kDirections; ++k) {
      const double half_turns = 2.0 * k / kDirections;
      all.push_back({boost::math::cos_pi(half_turns), boost::math::sin_pi(half_turns)});
    }
    return all;
  }();
  return table;
}

std::size_t distinct_direction_count(const ExponentPolynomial& q) {
  const bool even = std::ranges::all_of(q.terms(), [](const ExponentMonomial& term) {
    return (term.x1 + term.x2) % 2 == 0 || term.a == 0;
  });
  return even ? equiangular_directions().size() / 2 : equiangular_directions().size();
}

PolynomialAlongRay polynomial_along_ray(const ExponentPolynomial& q,
                                        const StandardDeviations& sigma,
                                        const PhasePlaneDirection& direction) {
  PolynomialAlongRay coefficients =
      q.coefficients_along_ray(sigma.x1 * direction.x1, sigma.x2 * direction.x2);
  while (!coefficients.empty() && coefficients.back() == 0) coefficients.pop_back();
  return coefficients;
}

namespace {

// Removes terms of a polynomial whose sign is unreliable, since they are rounding errors. In the
// scaled plane, terms with an unreliable sign are smaller than kRounding times the largest term.
ExponentPolynomial remove_terms_of_rounding(const ExponentPolynomial& q,
                                            const StandardDeviations& sigma) {
  constexpr double kRounding = 1e-10;
  const auto size = [&](const ExponentMonomial& term) {
    return std::abs(term.a) * std::pow(sigma.x1, term.x1) * std::pow(sigma.x2, term.x2);
  };
  double largest = 0;
  for (const ExponentMonomial& term : q.terms()) largest = std::max(largest, size(term));
  std::vector<ExponentMonomial> terms = q.terms();
  std::erase_if(terms,
                [&](const ExponentMonomial& term) { return size(term) <= kRounding * largest; });
  return ExponentPolynomial(std::move(terms));
}

// Returns the radius, in standard deviations, from which a polynomial of the radius rises: the
// largest radius below `end` at which the slope of the polynomial changes sign.
double last_radius_of_rise(const PolynomialAlongRay& ray, double sigma, double end, double step) {
  const PolynomialAlongRay slope = derivative_coefficients(ray);
  double radius = end;
  while (radius > 0 && evaluate_polynomial(slope, radius * sigma) > 0) radius -= step;
  return std::max(radius, 0.0);
}

}  // namespace

ExponentBehaviourAtInfinity leading_form(const ExponentPolynomial& with_rounding,
                                         const StandardDeviations& sigma,
                                         PhasePlaneDirectionRange plane) {
  const ExponentPolynomial q = remove_terms_of_rounding(with_rounding, sigma);
  ExponentBehaviourAtInfinity form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0, seen = 0;
  const std::size_t distinct = distinct_direction_count(q);
  PolynomialAlongRay worst;
  for (std::size_t k = 0; k < equiangular_directions().size(); ++k) {
    const PhasePlaneDirection e = equiangular_directions()[k];
    if (plane == PhasePlaneDirectionRange::half ? e.x1 < 0 : k >= distinct) continue;
    ++seen;
    const PolynomialAlongRay coefficients = polynomial_along_ray(q, sigma, e);
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
  if (!form.negative)
    form.rises_from = last_radius_of_rise(worst, 1, 4 * kLargestRayRadius, kRayScanStep / 8);
  return form;
}

ExponentBehaviourAtInfinity leading_form_along_directions(
    const ExponentPolynomial& q, const std::vector<PhasePlaneDirection>& directions, double sigma) {
  assert(!directions.empty());
  ExponentBehaviourAtInfinity form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0;
  PolynomialAlongRay worst;
  for (const PhasePlaneDirection& e : directions) {
    const PolynomialAlongRay coefficients = q.coefficients_along_ray(e.x1, e.x2);
    const double leading = coefficients.back();
    if (leading >= 0) ++rising;
    if (leading <= largest) continue;
    largest = leading;
    form.worst = e;
    worst = coefficients;
  }
  form.negative = rising == 0;
  form.rising_fraction = static_cast<double>(rising) / static_cast<double>(directions.size());
  if (!form.negative)
    form.rises_from = last_radius_of_rise(worst, sigma, kLargestRayRadius, kRayScanStep / 2);
  return form;
}

std::string describe_exponent_at_infinity(const ExponentBehaviourAtInfinity& form,
                                          const std::string& plane) {
  if (form.negative) return "although Q_n falls at infinity";
  return fmt::format(
      "and Q_n rises at infinity along {:.0f} % of all directions, most steeply along {} = "
      "({:.2f}, {:.2f}) from radius {:.2f} on",
      100 * form.rising_fraction, plane, form.worst.x1, form.worst.x2, form.rises_from);
}

}  // namespace fpkcheck::epc
