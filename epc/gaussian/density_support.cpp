#include "epc/gaussian/density_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "epc/summary.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

// Radius of the disc in which the peak of the exponent Q_n is searched, in standard deviations of
// the Gaussian weights. If the exponent Q_n outside the disc exceeds its peak in the disc,
// condition (19) of the paper is violated.
constexpr double kCoreRadius = 2;
constexpr int kRadialPanels = 6;

double minimum_between(const PolynomialAlongRay& slope, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (evaluate_polynomial(slope, middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

// Returns the radius between `low` and `high` at which the exponent Q_n along a ray equals `level`,
// by Newton's method with bracketing.
double crossing_between(const PolynomialAlongRay& q, const PolynomialAlongRay& slope, double level,
                        double low, double high) {
  double at = (low + high) / 2;
  for (int i = 0; i < 60; ++i) {
    const double excess = evaluate_polynomial(q, at) - level;
    (excess > 0 ? low : high) = at;
    const double next = at - excess / evaluate_polynomial(slope, at);
    if (std::abs(next - at) < 1e-14 * at) break;
    at = next > low && next < high ? next : (low + high) / 2;
  }
  return at;
}

struct DensitySupportEdgeOnRay {
  double radius;
  double peak;  // largest exponent Q_n at radii below the edge
};

// Finds the edge of the support along one direction, by the rules (a) to (c) of DensitySupport.
DensitySupportEdgeOnRay edge_on_ray(const PolynomialAlongRay& q, double core_peak) {
  const PolynomialAlongRay slope = derivative_coefficients(q);
  const double negligible = core_peak + std::log(DensitySupport::kNegligible);
  const double allowed = core_peak + std::log(kMaxSupportEdgeDensity);
  double lowest = 0, value_there = evaluate_polynomial(q, 0), peak = value_there, peak_there = peak;
  double slope_here = evaluate_polynomial(slope, 0);
  for (double rho = 0; rho < kLargestRayRadius; rho += kRayScanStep) {
    const double next = rho + kRayScanStep;
    const double value_next = evaluate_polynomial(q, next),
                 slope_next = evaluate_polynomial(slope, next);
    if (rho > kCoreRadius && value_next > core_peak) break;
    if (value_next < negligible) return {crossing_between(q, slope, negligible, rho, next), peak};
    double candidate = next, value = value_next;
    if (slope_here < 0 && slope_next >= 0) {
      candidate = minimum_between(slope, rho, next);
      value = evaluate_polynomial(q, candidate);
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

DensitySupport::DensitySupport(const ExponentPolynomial& q, const StandardDeviations& sigma)
    : sigma_(sigma) {
  const std::size_t distinct = distinct_direction_count(q);
  std::vector<PolynomialAlongRay> rays;
  double core_peak = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < distinct; ++k) {
    rays.push_back(polynomial_along_ray(q, sigma, equiangular_directions()[k]));
    for (double rho = 0; rho <= kCoreRadius; rho += kRayScanStep) {
      core_peak = std::max(core_peak, evaluate_polynomial(rays.back(), rho));
    }
  }
  peak_ = -std::numeric_limits<double>::infinity();
  for (const PolynomialAlongRay& along : rays) {
    const auto [radius, peak] = edge_on_ray(along, core_peak);
    radius_.push_back(radius);
    peak_ = std::max(peak_, peak);
  }
  for (std::size_t k = distinct; k < equiangular_directions().size(); ++k)
    radius_.push_back(radius_[k - distinct]);
  compute_integrals(rays);
}

void DensitySupport::compute_integrals(const std::vector<PolynomialAlongRay>& rays) {
  for (std::size_t k = 0; k < radius_.size(); ++k) {
    const double radius = radius_[k];
    sector_.push_back(std::min(radius, radius_[(k + 1) % radius_.size()]));
    x1_max_ = std::max(x1_max_, radius * std::abs(equiangular_directions()[k].x1) * sigma_.x1);
    x2_max_ = std::max(x2_max_, radius * std::abs(equiangular_directions()[k].x2) * sigma_.x2);
  }
  const auto [least, greatest] = std::ranges::minmax(radius_);
  least_radius_ = least;
  greatest_radius_ = greatest;

  const auto unit = numerics::composite_gauss_points(0.0, 1.0, kRadialPanels);
  double edge_sum = 0, sum = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const double radius = radius_[k];
    const auto relative = [&](double rho) {
      return std::exp(evaluate_polynomial(rays[k], rho) - peak_);
    };
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
  // The estimate of the probability outside the support uses int_R^inf exp(-(rho^2 - R^2)/2) rho
  // drho = 1, with the radius R of the edge of the support.
  cut_off_ = edge_sum / sum;
}

bool DensitySupport::contains(double x1, double x2) const {
  const double u1 = x1 / sigma_.x1, u2 = x2 / sigma_.x2;
  const double square = u1 * u1 + u2 * u2;
  if (square < least_radius_ * least_radius_) return true;
  if (square > greatest_radius_ * greatest_radius_) return false;
  double turn = std::atan2(u2, u1) / (2 * std::numbers::pi);
  if (turn < 0) turn += 1;
  const auto count = static_cast<double>(sector_.size());
  const auto k = static_cast<std::size_t>(turn * count) % sector_.size();
  return square < sector_[k] * sector_[k];
}

double log_normalising_constant(const DensitySupport& support) {
  return -support.largest_exponent_in_support() - std::log(support.integral_relative_to_peak());
}

transform::SmoothDensity density_from_exponent(const ExponentPolynomial& q,
                                               const DensitySupport& support, double log_constant) {
  const auto plane = [q, support, log_constant](double x1, double x2) {
    return support.contains(x1, x2) ? std::exp(q(x1, x2) + log_constant) : 0;
  };
  const bool even = std::ranges::all_of(
      q.terms(), [](const ExponentMonomial& t) { return (t.x1 + t.x2) % 2 == 0; });
  if (even) {  // the two points (z, z') and (-z, -z') of paper (5) have equal densities
    return {[plane](double y, double v) { return 2 * plane(y, v); }, support.x1_max(),
            support.x2_max()};
  }
  return transform::zhuravlev_transform(
      {.value = plane, .x1_max = support.x1_max(), .x2_max = support.x2_max()});
}

transform::SmoothDensity density_without_wall(const ExponentPolynomial& q,
                                              const DensitySupport& support, double log_constant) {
  return {.value =
              [q, support, log_constant](double y, double v) {
                return support.contains(y, v) ? std::exp(q(y, v) + log_constant) : 0;
              },
          .y_max = support.x1_max(),
          .v_max = support.x2_max(),
          .y_min = -support.x1_max()};
}

transform::SmoothDensity density_on_support(const ExponentPolynomial& q,
                                            const DensitySupport& support, bool has_wall) {
  const double log_constant = log_normalising_constant(support);
  return has_wall ? density_from_exponent(q, support, log_constant)
                  : density_without_wall(q, support, log_constant);
}

}  // namespace fpkcheck::epc::gaussian
