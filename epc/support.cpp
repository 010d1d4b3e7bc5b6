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
constexpr double kRadialStep = 0.1;
// The peak is sought within two deviations: a rise further out is no peak but a failure of (19).
constexpr double kCore = 2;
// Terms of Q_n below this share of the largest, in the scaled plane, are rounding and have no sign.
constexpr double kRounding = 1e-10;
constexpr int kPanels = 6;

using Ray = std::vector<double>;  // coefficients of rho -> Q_n

// Exactly on the axes where it should be, so that a term which vanishes there does vanish.
const std::vector<Direction>& directions() {
  static const std::vector<Direction> table = [] {
    std::vector<Direction> all;
    for (int k = 0; k < kDirections; ++k) {
      const double half_turns = 2.0 * k / kDirections;
      all.push_back({boost::math::cos_pi(half_turns), boost::math::sin_pi(half_turns)});
    }
    return all;
  }();
  return table;
}

// The directions that differ: opposite ones are alike for a Q_n of even degrees only.
int distinct_directions(const Polynomial& q) {
  const bool even = std::ranges::all_of(
      q.terms(), [](const Term& term) { return (term.x1 + term.x2) % 2 == 0 || term.a == 0; });
  return even ? kDirections / 2 : kDirections;
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

// Where Q_n, falling from low to high, crosses a level: Newton's method kept between the two.
double crossing_between(const Ray& q, const Ray& slope, double level, double low, double high) {
  double at = (low + high) / 2;
  for (int i = 0; i < 60; ++i) {
    const double excess = horner(q, at) - level;
    (excess > 0 ? low : high) = at;
    const double next = at - excess / horner(slope, at);
    if (std::abs(next - at) < 1e-14 * at) break;
    at = next > low && next < high ? next : (low + high) / 2;
  }
  return at;
}

struct Edge {
  double radius;
  double peak;  // largest Q_n met on the way
};

// The edge along one direction, rules (a) to (c).
Edge edge(const Ray& q, double core_peak) {
  const Ray slope = derivative(q);
  const double negligible = core_peak + std::log(Support::kNegligible);
  const double allowed = core_peak + std::log(Support::kEdgeAllowed);
  double lowest = 0, value_there = horner(q, 0), peak = value_there, peak_there = peak;
  double slope_here = horner(slope, 0);
  for (double rho = 0; rho < Support::kFarthest; rho += kRadialStep) {
    const double next = rho + kRadialStep;
    const double value_next = horner(q, next), slope_next = horner(slope, next);
    if (rho > kCore && value_next > core_peak) break;
    if (value_next < negligible) return {crossing_between(q, slope, negligible, rho, next), peak};
    double candidate = next, value = value_next;
    if (slope_here < 0 && slope_next >= 0) {
      candidate = minimum_between(slope, rho, next);
      value = horner(q, candidate);
      if (value < allowed) return {candidate, peak};
    }
    if (value < value_there) {
      lowest = candidate;
      value_there = value;
      peak_there = peak;
    }
    peak = std::max(peak, value_next);
    slope_here = slope_next;
  }
  return {lowest, peak_there};
}

}  // namespace

LeadingForm leading_form(const Polynomial& with_rounding, const Deviations& sigma, Plane plane) {
  const Polynomial q = without_rounding(with_rounding, sigma);
  LeadingForm form{true, {1, 0}, 0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  int rising = 0, seen = 0;
  const int distinct = distinct_directions(q);
  Ray worst;
  for (int k = 0; k < kDirections; ++k) {
    const Direction e = directions()[k];
    if (plane == Plane::half ? e.x1 < 0 : k >= distinct) continue;
    ++seen;
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
  form.rising_share = static_cast<double>(rising) / seen;
  if (!form.negative) {
    // The last change of sign of the slope; beyond kFarthest it does not matter where.
    const Ray slope = derivative(worst);
    double rho = 4 * Support::kFarthest;
    while (rho > 0 && horner(slope, rho) > 0) rho -= kRadialStep / 8;
    form.rises_from = std::max(rho, 0.0);
  }
  return form;
}

Support::Support(const Polynomial& q, const Deviations& sigma) : sigma_(sigma) {
  const int distinct = distinct_directions(q);
  std::vector<Ray> rays;
  double core_peak = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < distinct; ++k) {
    rays.push_back(ray(q, sigma, directions()[k]));
    for (double rho = 0; rho <= kCore; rho += kRadialStep) {
      core_peak = std::max(core_peak, horner(rays.back(), rho));
    }
  }
  peak_ = -std::numeric_limits<double>::infinity();
  for (const Ray& along : rays) {
    const auto [radius, peak] = edge(along, core_peak);
    radius_.push_back(radius);
    peak_ = std::max(peak_, peak);
  }
  for (int k = distinct; k < kDirections; ++k) radius_.push_back(radius_[k - distinct]);
  measure(rays);
}

void Support::measure(const std::vector<Ray>& rays) {
  for (int k = 0; k < kDirections; ++k) {
    const double radius = radius_[k];
    sector_.push_back(std::min(radius, radius_[(k + 1) % kDirections]));
    x1_max_ = std::max(x1_max_, radius * std::abs(directions()[k].x1) * sigma_.x1);
    x2_max_ = std::max(x2_max_, radius * std::abs(directions()[k].x2) * sigma_.x2);
  }
  const auto [least, greatest] = std::ranges::minmax(radius_);
  least_radius_ = least;
  greatest_radius_ = greatest;

  const auto unit = transform::panel_points(0.0, 1.0, kPanels);
  double edge_sum = 0, sum = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const double radius = radius_[k];
    const auto relative = [&](double rho) { return std::exp(horner(rays[k], rho) - peak_); };
    const double at_edge = relative(radius);
    edge_ratio_ = std::max(edge_ratio_, at_edge);
    edge_sum += at_edge;
    for (const auto& [share, weight] : unit) {
      sum += radius * radius * weight * share * relative(radius * share);
    }
  }
  const double element =
      sigma_.x1 * sigma_.x2 * 2 * std::numbers::pi / static_cast<double>(rays.size());
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
