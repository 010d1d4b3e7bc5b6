#include "epc/moment/density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "epc/half_plane/root_search.hpp"

namespace fpkcheck::epc::moment {

transform::SmoothDensity density_from_exponent(
    const ExponentPolynomial& q, const EnergySublevelSet& domain,
    const half_plane::ExponentConfinementTerm& confinement, double log_constant) {
  return {.value =
              [q, domain, confinement, log_constant](double y, double v) {
                if (!domain.contains(y, v)) return 0.0;
                return std::exp(q(y, v) + confinement(domain.energy(y, v)) + log_constant);
              },
          .y_max = domain.y_max(),
          .v_max = domain.v_max(),
          .y_min = domain.y_low()};
}

half_plane::DensityContour energy_contour_of_domain_edge(const EnergySublevelSet& domain) {
  constexpr int kPoints = 48;
  half_plane::DensityContour contour;
  for (const problem::HalfCycle& part : domain.y_intervals()) {
    // The area A inside the contour of energy h has dA/dh = integral of dy/|v| over the points (y,
    // +-v), with y = centre + half_length sin(phi).
    const double centre = (part.left + part.right) / 2;
    const double half_length = (part.right - part.left) / 2;
    for (int i = 0; i < kPoints; ++i) {
      const double phi = std::numbers::pi * ((i + 0.5) / kPoints - 0.5);
      const double y = centre + half_length * std::sin(phi);
      const double v = domain.velocity_half_width(y);
      const double dy = std::numbers::pi / kPoints * half_length * std::cos(phi);
      for (const double side : {1, -1}) {
        contour.push_back({.s = y, .t = side * v, .y = y, .v = side * v, .area = dy / v});
      }
    }
  }
  return contour;
}

double largest_exponent_on_contour(const ExponentPolynomial& q, const problem::Problem& problem,
                                   double energy) {
  const EnergySublevelSet domain(problem, energy);
  double largest = -std::numeric_limits<double>::infinity();
  for (const problem::HalfCycle& part : domain.y_intervals()) {
    const double at_low = domain.velocity_half_width(part.left);
    const double at_high = part.right_is_wall ? domain.velocity_half_width(part.right) : 0;
    largest = std::max({largest, q(part.right, at_high), q(part.right, -at_high),
                        q(part.left, at_low), q(part.left, -at_low)});
  }
  for (const auto& point : energy_contour_of_domain_edge(domain))
    largest = std::max(largest, q(point.y, point.v));
  return largest;
}

ExponentDecayRange find_exponent_decay_range(const ExponentPolynomial& q,
                                             const problem::Problem& problem, double first_energy,
                                             double last_energy, double depth) {
  constexpr int kContoursBefore = 40;
  constexpr double kGrowth = 1.05;
  ExponentDecayRange fall{-std::numeric_limits<double>::infinity(), std::nullopt};
  for (int i = 1; i <= kContoursBefore; ++i) {
    fall.peak = std::max(
        fall.peak, largest_exponent_on_contour(q, problem, first_energy * i / kContoursBefore));
  }
  double before = std::numeric_limits<double>::infinity();
  for (double energy = first_energy; energy <= last_energy; energy *= kGrowth) {
    const double largest = largest_exponent_on_contour(q, problem, energy);
    if (largest > before) break;
    if (largest < fall.peak - depth) {
      fall.crossing = energy;
      break;
    }
    before = largest;
  }
  return fall;
}

double density_ratio_at_confinement_level(const half_plane::ClosureDensity& closure,
                                          const problem::Problem& problem) {
  return std::exp(largest_exponent_on_contour(closure.q, problem, closure.level) - closure.peak);
}

double density_ratio_at_edge(const half_plane::ClosureDensity& closure,
                             const problem::Problem& problem, DensityTailTreatment tail) {
  const double confined =
      half_plane::make_exponent_confinement(closure.level, tail)(closure.support);
  return std::exp(largest_exponent_on_contour(closure.q, problem, closure.support) - closure.peak +
                  confined);
}

}  // namespace fpkcheck::epc::moment
