#include "epc/amplitude/closure_formulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "epc/half_plane/root_search.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::amplitude {

using Eigen::VectorXd;
using half_plane::ClosureDensity;
using half_plane::ClosureRootSearchStage;
using half_plane::ExponentConfinementTerm;
using half_plane::QuadraturePointCounts;
using half_plane::QuadraturePoints;
using half_plane::QuadratureRefinementCriterion;

namespace {

// Candidates for the confinement level of the density: amplitudes at which the exponent Q_n lies
// kDepths below its peak, in the order of the attempts.
constexpr std::array kDepths{24.0, 18.0, 32.0};
// Further candidates for the confinement level of the density: multiples of the amplitude at which
// the exponent Q_n begins to rise, and multiples of the standard deviation of v.
constexpr std::array kBeyondDecayExtent{1.2, 1.0};
constexpr std::array kLevelDeviations{8.0, 6.5, 11.0};
constexpr double kFarthestDeviations = 30;
// Largest accepted closure density at the confinement level, relative to the peak density. If the
// density at the confinement level were larger, the confinement term would determine the density.
constexpr double kLevelDensityLimit = 1e-4;

double largest_scan_amplitude(double temperature) {
  return kFarthestDeviations * std::sqrt(temperature);
}

}  // namespace

double exponent_with_gaussian_tail(const ExponentInPolarCoordinates& q,
                                   const ClosureDensity& closure, double rho, double theta) {
  const double inside = std::min(rho, closure.end_of_exponent_decay);
  return q(inside, theta) - (rho * rho - inside * inside) / (2 * closure.temperature);
}

ClosureDensity ClosureFormulation::initial_density() const {
  ClosureDensity closure{.q = ExponentPolynomial({{2, 0, -1 / (2 * temperature_)}}),
                         .temperature = temperature_};
  closure.end_of_exponent_decay = end_of_exponent_decay(closure.q, temperature_);
  return closure;
}

std::vector<double> ClosureFormulation::candidate_confinement_energies(
    const ClosureDensity& guess, ClosureRootSearchStage) const {
  const double end = largest_scan_amplitude(guess.temperature);
  std::vector<double> candidate_confinement_energies;
  const auto add = [&](double rho) {
    candidate_confinement_energies.push_back(energy_of_amplitude(rho));
  };
  for (const double depth : kDepths) {
    const ExponentDecayRange fall = find_exponent_decay_range(polar_exponent(guess.q), depth, end);
    if (fall.crossing) add(*fall.crossing);
  }
  if (guess.end_of_exponent_decay < end) {
    for (const double factor : kBeyondDecayExtent) add(factor * guess.end_of_exponent_decay);
  }
  for (const double deviations : kLevelDeviations) add(deviations * std::sqrt(guess.temperature));
  return candidate_confinement_energies;
}

QuadraturePointCounts ClosureFormulation::quadrature_point_counts(
    int order, double level_over_temperature, ClosureRootSearchStage stage) const {
  const int least = stage == ClosureRootSearchStage::rough ? 16 : 20;
  const double width = std::max(1.0, std::sqrt(2 * level_over_temperature) / kLevelDeviations[0]);
  const int rho = static_cast<int>((least + 2 * order) * width);
  return {rho, least + 2 * order, rho};
}

QuadratureRefinementCriterion ClosureFormulation::quadrature_refinement_criterion() const {
  return {QuadratureRefinementCriterion::ChangeMeasure::solved, 1e-5};
}

double ClosureFormulation::exponent_of_initial_guess(const ClosureDensity& guess, double s,
                                                     double t) const {
  return exponent_with_gaussian_tail(polar_exponent(guess.q), guess, s, phase(s, t));
}

double ClosureFormulation::end_of_exponent_decay(const ExponentPolynomial& q,
                                                 double temperature) const {
  return find_exponent_decay_range(polar_exponent(q), kDepths.back(),
                                   largest_scan_amplitude(temperature))
      .extent;
}

// The least-squares fit of the exponent Q_n has weights proportional to a power of the density.
// With a power of the density below 1, points in the tail have a larger weight in the fit. With the
// power 1 of the density the fit would return the polynomial of the initial guess.
VectorXd ClosureFormulation::weights_of_exponent_fit(const ClosureDensity& guess, double support,
                                                     const QuadraturePoints& points,
                                                     const VectorXd& exponent,
                                                     const VectorXd&) const {
  constexpr double kFlatter = 0.5;
  const double power = amplitude_of_energy(support) > guess.end_of_exponent_decay ? kFlatter : 1;
  const VectorXd mass =
      points.weight.array() * (power * (exponent.array() - exponent.maxCoeff())).exp();
  return mass / mass.sum();
}

double ClosureFormulation::decay_ratio(const ClosureDensity& closure,
                                       ClosureRootSearchStage) const {
  constexpr int kInside = 50, kOutside = 12;
  const ExponentConfinementTerm confinement =
      half_plane::make_exponent_confinement(closure.level, tail_);
  const ExponentInPolarCoordinates q = polar_exponent(closure.q);
  const double rho = amplitude_of_energy(closure.level), end = amplitude_of_energy(closure.support);
  double peak = maximum_over_phase(q, 0), outside = -std::numeric_limits<double>::infinity();
  for (int i = 1; i <= kInside; ++i)
    peak = std::max(peak, maximum_over_phase(q, rho * i / kInside));
  for (int i = 0; i <= kOutside; ++i) {
    const double at = rho + (end - rho) * i / kOutside;
    outside = std::max(outside, maximum_over_phase(q, at) + confinement(energy_of_amplitude(at)));
  }
  return std::exp(outside - peak);
}

double ClosureFormulation::max_decay_ratio(ClosureRootSearchStage) const { return 1e-6; }

std::string inadmissible_reason(const char* quantity, double at_level, double edge) {
  if (!(at_level < kLevelDensityLimit)) {
    return fmt::format("{} at or beyond the confinement level is {:.1e} of its peak (limit {:.0e})",
                       quantity, at_level, kLevelDensityLimit);
  }
  if (!(edge < kMaxSupportEdgeDensity)) {
    return fmt::format("{} on the edge of its support is {:.1e} of its peak (limit {:.0e})",
                       quantity, edge, kMaxSupportEdgeDensity);
  }
  return "";
}

}  // namespace fpkcheck::epc::amplitude
