#include "epc/moment/energy_averaged_formulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "epc/form/acceptance_limits.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/moment/contour_decay.hpp"
#include "epc/moment/density_at_level.hpp"
#include "epc/moment/equations.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::epc::moment {

using half_plane::ClosureDensity;
using half_plane::QuadratureSize;
using half_plane::SearchStage;

namespace {

// Candidates d for the confinement level, in the order of the attempts. The level is the energy
// with Phi = d^2/2, which is the exponent of a Gaussian at d standard deviations.
constexpr std::array kDeviations{6.5, 7.2, 5.2, 8.0};
constexpr double kLargestScanRatio = 8;  // largest energy of a scan, in units of the first level
// Lower limits of the confinement level, in units of bulk_energy(). With these limits the
// confinement term (energy / level)^16 is at most 5e-4 and 4e-8 at bulk_energy().
constexpr double kAboveBulk = 1.6, kFarAboveBulk = 2.9;
// Lower limit of the confinement level, in units of barrier_energy().
constexpr double kAboveBarrier = 1.3;

double depth_of(double deviations) { return deviations * deviations / 2; }

// Relaxation rate D_eff / E[v^2], which equals the damping c of a linear oscillator, and otherwise
// the combined effect of damping and impacts. The rate is at least kRounding times the frequency.
// In a smaller unit the rounding errors of the undamped motion would dominate the residual.
double relaxation_rate(const problem::Problem& problem, double temperature) {
  constexpr double kRounding = 1e-4;
  return std::max(total_intensity(problem) / (2 * temperature),
                  kRounding * problem::scales(problem).frequency);
}

}  // namespace

EnergyAveragedFormulation::EnergyAveragedFormulation(const problem::Problem& problem,
                                                     const Options& options,
                                                     std::vector<double> rate_times_moment)
    : problem_(problem),
      tail_(options.tail),
      rate_moment_(std::move(rate_times_moment)),
      averaged_(problem),
      rate_unit_(relaxation_rate(problem, averaged_.temperature())) {}

// The initial density has no Q_n: exponent_of_guess() evaluates the averaged density instead.
ClosureDensity EnergyAveragedFormulation::initial_density() const {
  return {.temperature = averaged_.temperature()};
}

// The lowest order is 4: a Gaussian, order 2, approximates no ring-shaped density, and few
// densities with several wells.
int EnergyAveragedFormulation::first_order(int order) const { return std::min(order, 4); }

std::vector<double> EnergyAveragedFormulation::confinement_levels(const ClosureDensity& guess,
                                                                  SearchStage stage) const {
  const double least =
      std::max(kAboveBulk * averaged_.bulk_energy(), kAboveBarrier * averaged_.barrier_energy());
  const double warmer = std::clamp(guess.temperature / averaged_.temperature(), 0.5, 2.0);
  std::vector<double> confinement_levels;
  for (const double deviations : kDeviations) {
    confinement_levels.push_back(
        std::max(least, warmer * averaged_.energy_at_depth(depth_of(deviations))));
  }
  confinement_levels.erase(std::unique(confinement_levels.begin(), confinement_levels.end()),
                           confinement_levels.end());
  if (stage == SearchStage::last && !guess.q.terms().empty()) {
    if (const auto whole = negligible_level(guess, confinement_levels.front())) {
      confinement_levels.insert(confinement_levels.begin(), *whole);
    }
  }
  return confinement_levels;
}

std::optional<double> EnergyAveragedFormulation::improved_confinement_level(
    const ClosureDensity&, const ClosureDensity& closure) const {
  const auto whole = negligible_level(closure, closure.level);
  return whole && *whole > kMinLevelRatio * closure.level ? whole : std::nullopt;
}

// Energy at which the Q_n of a density lies kNegligibleDepth below its peak; empty if there is
// none.
std::optional<double> EnergyAveragedFormulation::negligible_level(const ClosureDensity& closure,
                                                                  double from) const {
  const double begin = std::max(from, kFarAboveBulk * averaged_.bulk_energy());
  return scan_decay(closure.q, problem_, begin,
                    kLargestScanRatio * averaged_.energy_at_depth(depth_of(kDeviations[0])),
                    kNegligibleDepth)
      .crossing;
}

QuadratureSize EnergyAveragedFormulation::quadrature_size(int order, double level_over_temperature,
                                                          SearchStage stage) const {
  const double width = std::max(1.0, std::sqrt(2 * level_over_temperature) / kDeviations[0]);
  const int least = stage == SearchStage::rough ? 20 : 32;
  const auto widened = [&](int points) { return static_cast<int>(points * std::sqrt(width)); };
  return {widened(least + 8 + 2 * order), widened(least + 2 * order), widened(least + 2 * order)};
}

half_plane::QuadratureRefinement EnergyAveragedFormulation::quadrature_refinement() const {
  return {half_plane::QuadratureRefinement::ChangeMeasure::estimated, 1e-9};
}

half_plane::QuadraturePoints EnergyAveragedFormulation::points_below_energy(
    double support, const QuadratureSize& size) const {
  return EnergyDomain(problem_, support).quadrature_points(size.s, size.t);
}

half_plane::ClosureEquations EnergyAveragedFormulation::closure_equations(
    double support, const half_plane::Confinement& confinement, half_plane::Basis basis,
    half_plane::QuadraturePoints points, const QuadratureSize& size) const {
  return moment::closure_equations(problem_, rate_moment_, EnergyDomain(problem_, support),
                                   confinement, std::move(basis), std::move(points), size.wall);
}

double EnergyAveragedFormulation::exponent_of_guess(const ClosureDensity& guess, double y,
                                                    double v) const {
  return guess.q.terms().empty() ? averaged_(y, v) : guess.q(y, v);
}

// In a fit to the averaged density, the weights are a small power of this density. The fit then
// also covers large energies, where Q_n might rise.
Eigen::VectorXd EnergyAveragedFormulation::fit_weights(const ClosureDensity& guess, double,
                                                       const half_plane::QuadraturePoints& points,
                                                       const Eigen::VectorXd& exponent,
                                                       const Eigen::VectorXd& mass) const {
  if (!guess.q.terms().empty()) return mass;
  constexpr double kFlatter = 1.0 / 3;
  const Eigen::VectorXd flat =
      points.weight.array() * (kFlatter * (exponent.array() - exponent.maxCoeff())).exp();
  return flat / flat.sum();
}

double EnergyAveragedFormulation::decay_ratio(const ClosureDensity& closure,
                                              SearchStage stage) const {
  const double at_level = density_ratio_at_level(closure, problem_);
  if (stage == SearchStage::rough) return at_level;
  return std::max(density_ratio_at_edge(closure, problem_, tail_),
                  at_level * (kEdgeDensityLimit / kPreferredLevelDensity));
}

double EnergyAveragedFormulation::decay_ratio_limit(SearchStage stage) const {
  return stage == SearchStage::rough ? kIntermediateLevelDensity : kEdgeDensityLimit;
}

}  // namespace fpkcheck::epc::moment
