#include "epc/support.hpp"

#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "transform/panels.hpp"

namespace fpkcheck::epc {
namespace {

constexpr int kDirections = 1440;
constexpr double kRadialStep = 0.05;
// The peak is sought within two deviations: a rise further out is no peak but a failure of (19).
constexpr double kCore = 2;
// Terms of Q_n below this share of the largest, in the scaled plane, are rounding and have no sign.
constexpr double kRounding = 1e-10;
constexpr int kPanels = 12;

using Ray = std::vector<double>;  // coefficients of rho -> Q_n

// Exactly on the axes where it should be, so that a term which vanishes there does vanish.
Direction direction(int k) {
  const double half_turns = 2.0 * k / kDirections;
  return {boost::math::cos_pi(half_turns), boost::math::sin_pi(half_turns)};
}

Polynomial without_rounding(const Polynomial& q, const Deviations& sigma) {
  const auto size = [&](const Term& term) {
    return std::abs(term.a) * std::pow(sigma.x1, term.x1) * std::pow(sigma.x2, term.x2);
  };
  double largest = 0;
  for (const Term& term : q.terms()) largest = std::max(largest, size(term));
  std::vector<Term> terms = q.terms();
  std::erase_if(terms, [&](const Term& term) { return size(term) <= kRounding * largest; });
  return Polynomial(std::move(terms));
}

Ray ray(const Polynomial& q, const Deviations& sigma, const Direction& e) {
  Ray coefficients = q.along(sigma.x1 * e.x1, sigma.x2 * e.x2);
  while (!coefficients.empty() && coefficients.back() == 0) coefficients.pop_back();
  return coefficients;
}

// Where Q_n along the ray changes from falling to rising between two radii.
double minimum_between(const Ray& slope, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (horner(slope, middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

// Where Q_n, falling from low to high, crosses a level.
double crossing_between(const Ray& q, double level, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (horner(q, middle) > level ? low : high) = middle;
  }
  return (low + high) / 2;
}

// The edge along one direction, rules (a) to (c).
double edge(const Ray& q, double core_peak) {
  const Ray slope = derivative(q);
  const double negligible = core_peak + std::log(Support::kNegligible);
  const double allowed = core_peak + std::log(Support::kEdgeAllowed);
  double lowest = 0;
  for (double rho = 0; rho < Support::kFarthest; rho += kRadialStep) {
    const double next = rho + kRadialStep;
    if (rho > kCore && horner(q, next) > core_peak) break;
    if (horner(q, next) < negligible) return crossing_between(q, negligible, rho, next);
    double candidate = next;
    if (horner(slope, rho) < 0 && horner(slope, next) >= 0) {
      candidate = minimum_between(slope, rho, next);
      if (horner(q, candidate) < allowed) return candidate;
    }
    if (horner(q, candidate) < horner(q, lowest)) lowest = candidate;
  }
  return lowest;
}

}  // namespace

LeadingForm leading_form(const Polynomial& with_rounding, const Deviations& sigma, Plane plane) {
  const Polynomial q = without_rounding(with_rounding, sigma);
  LeadingForm form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0, directions = 0;
  Ray worst;
  for (int k = 0; k < kDirections; ++k) {
    const Direction e = direction(k);
    if (plane == Plane::half && e.x1 < 0) continue;
    ++directions;
    const Ray coefficients = ray(q, sigma, e);
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
  form.rising_share = static_cast<double>(rising) / directions;
  if (!form.negative) {
    // The last change of sign of the slope; beyond kFarthest it does not matter where.
    const Ray slope = derivative(worst);
    double rho = 4 * Support::kFarthest;
    while (rho > 0 && horner(slope, rho) > 0) rho -= kRadialStep / 4;
    form.rises_from = std::max(rho, 0.0);
  }
  return form;
}

Support::Support(const Polynomial& q, const Deviations& sigma) : sigma_(sigma) {
  std::vector<Ray> rays;
  double core_peak = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDirections; ++k) {
    rays.push_back(ray(q, sigma, direction(k)));
    for (double rho = 0; rho <= kCore; rho += kRadialStep) {
      core_peak = std::max(core_peak, horner(rays.back(), rho));
    }
  }
  for (const Ray& along : rays) radius_.push_back(edge(along, core_peak));
  measure(rays);
}

void Support::measure(const std::vector<Ray>& rays) {
  peak_ = 0;  // Q_n at the origin
  for (int k = 0; k < kDirections; ++k) {
    const double radius = radius_[k];
    sector_.push_back(std::min(radius, radius_[(k + 1) % kDirections]));
    x1_max_ = std::max(x1_max_, radius * std::abs(direction(k).x1) * sigma_.x1);
    x2_max_ = std::max(x2_max_, radius * std::abs(direction(k).x2) * sigma_.x2);
    for (double rho = 0; rho < radius; rho += kRadialStep) {
      peak_ = std::max(peak_, horner(rays[k], rho));
    }
  }
  const auto [least, greatest] = std::ranges::minmax(radius_);
  least_radius_ = least;
  greatest_radius_ = greatest;

  double edge_sum = 0, sum = 0;
  for (int k = 0; k < kDirections; ++k) {
    const auto relative = [&](double rho) { return std::exp(horner(rays[k], rho) - peak_); };
    const double at_edge = relative(radius_[k]);
    edge_ratio_ = std::max(edge_ratio_, at_edge);
    edge_sum += at_edge;
    sum += transform::integrate_panels([&](double rho) { return rho * relative(rho); }, 0.0,
                                       radius_[k], kPanels);
  }
  const double element = sigma_.x1 * sigma_.x2 * 2 * std::numbers::pi / kDirections;
  integral_ = sum * element;
  // int_R^inf exp(-(rho^2 - R^2)/2) rho drho = 1
  cut_off_ = edge_sum / sum;
}

bool Support::contains(double x1, double x2) const {
  const double u1 = x1 / sigma_.x1, u2 = x2 / sigma_.x2;
  const double square = u1 * u1 + u2 * u2;
  if (square < least_radius_ * least_radius_) return true;
  if (square > greatest_radius_ * greatest_radius_) return false;
  double turn = std::atan2(u2, u1) / (2 * std::numbers::pi);
  if (turn < 0) turn += 1;
  const auto k = static_cast<std::size_t>(turn * kDirections) % kDirections;
  return square < sector_[k] * sector_[k];
}

}  // namespace fpkcheck::epc
