#include "epc/moment/root_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "epc/half_plane/newton.hpp"
#include "epc/moment/density.hpp"
#include "epc/moment/energy_averaged_exponent.hpp"
#include "epc/moment/equations.hpp"
#include "epc/selection_policy.hpp"
#include "epc/summary.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::epc::moment {
namespace {

using half_plane::ClosureDensity;
using half_plane::ClosureRootSearchStage;
using half_plane::ExponentConfinementTerm;
using half_plane::OrthonormalBasis;
using half_plane::QuadraturePointCounts;
using half_plane::QuadraturePoints;
using half_plane::QuadratureRefinementCriterion;

// Products lambda E[Y^j] of the arrival rate and the moments of impulses, j = 0 .. n; 0 for terms
// that the density equation lacks.
std::vector<double> rates_times_moments(const problem::Problem& problem,
                                        const ClosureOptions& options) {
  std::vector<double> moments(options.order + 1);
  const int last = closure_density_equation(options) == DensityEquation::white ? 2 : options.order;
  for (int j = 1; j <= last; ++j) moments[j] = problem.impulses.rate_times_moment(j);
  return moments;
}

double depth_at_deviations(double deviations) { return deviations * deviations / 2; }

class MomentFormulation : public half_plane::ClosureFormulation {
 public:
  // @param temperature approximate value of E[v^2]
  MomentFormulation(const problem::Problem& problem, const ClosureOptions& options,
                    double temperature)
      : problem_(problem),
        tail_(options.tail),
        rate_moment_(rates_times_moments(problem, options)),
        rate_unit_(half_plane::relaxation_rate_unit(problem, temperature)) {}

  double relaxation_rate_unit() const override { return rate_unit_; }

  // Candidates for the confinement level: the energy at which exp(Q_n) of the initial guess is
  // negligible, if such an energy exists, followed by candidate_levels().
  std::vector<double> candidate_confinement_energies(const ClosureDensity& guess,
                                                     ClosureRootSearchStage stage) const override {
    std::vector<double> levels = candidate_levels(guess);
    if (stage == ClosureRootSearchStage::rough || guess.q.terms().empty()) return levels;
    const auto whole = negligible_level(guess, levels.front(), guess);
    if (whole) levels.insert(levels.begin(), *whole);
    return levels;
  }

  std::optional<double> improved_confinement_level(const ClosureDensity& guess,
                                                   const ClosureDensity& closure) const override {
    const auto whole = negligible_level(closure, closure.level, guess);
    return whole && *whole > kMinLevelRatio * closure.level ? whole : std::nullopt;
  }

  QuadratureRefinementCriterion quadrature_refinement_criterion() const override {
    // Kinks of a formula along lines oblique to the axes y and v limit the order of the quadrature.
    // The tolerance of the quadrature of formulas is below the limit of solve_closure(), and more
    // quadrature points would not reduce the error of the closure.
    const double tolerance = problem_.system.has_polynomial_force() ? 1e-9 : 1e-7;
    return {QuadratureRefinementCriterion::ChangeMeasure::estimated, tolerance};
  }

  QuadraturePoints quadrature_points_below_energy(
      double support, const QuadraturePointCounts& size) const override {
    return EnergySublevelSet(problem_, support).quadrature_points(size.s, size.t);
  }

  half_plane::ClosureEquations closure_equations(double support,
                                                 const ExponentConfinementTerm& confinement,
                                                 OrthonormalBasis basis, QuadraturePoints points,
                                                 const QuadraturePointCounts& size) const override {
    return moment::closure_equations(problem_, rate_moment_, EnergySublevelSet(problem_, support),
                                     confinement, std::move(basis), std::move(points), size.wall);
  }

  // Density at the confinement level, for intermediate closure orders, or on the edge of the
  // support, for the requested closure order, relative to the peak.
  double decay_ratio(const ClosureDensity& closure, ClosureRootSearchStage stage) const override {
    return stage == ClosureRootSearchStage::rough
               ? density_ratio_at_confinement_level(closure, problem_)
               : density_ratio_at_edge(closure, problem_, tail_);
  }
  double max_decay_ratio(ClosureRootSearchStage stage) const override {
    return stage == ClosureRootSearchStage::rough ? kIntermediateLevelDensity
                                                  : kMaxSupportEdgeDensity;
  }

 protected:
  // Candidates for the confinement level at which a density like the initial guess has decayed.
  virtual std::vector<double> candidate_levels(const ClosureDensity& guess) const = 0;
  virtual std::pair<double, double> energy_scan_range(double from,
                                                      const ClosureDensity& guess) const = 0;

  const problem::Problem& problem_;

 private:
  // Energy at which the exponent Q_n of a density lies kNegligibleExponentDepth below its peak;
  // empty if the scan of energies finds no such energy.
  std::optional<double> negligible_level(const ClosureDensity& closure, double from,
                                         const ClosureDensity& guess) const {
    const auto [begin, end] = energy_scan_range(from, guess);
    return find_exponent_decay_range(closure.q, problem_, begin, end, kNegligibleExponentDepth)
        .crossing;
  }

  DensityTailTreatment tail_;
  std::vector<double> rate_moment_;
  double rate_unit_;
};

// Root search from the Gaussian density of equivalent linearisation.
class LinearisedFormulation final : public MomentFormulation {
 public:
  LinearisedFormulation(const problem::Problem& problem, const ClosureOptions& options)
      : LinearisedFormulation(problem, options, problem::motion_scales(problem)) {}

  ClosureDensity initial_density() const override {
    const double s1 = scales_.displacement_deviation, s2 = scales_.velocity_deviation;
    return {.q = ExponentPolynomial({{1, 0, scales_.centre / (s1 * s1)},
                                     {2, 0, -1 / (2 * s1 * s1)},
                                     {0, 2, -1 / (2 * s2 * s2)}}),
            .temperature = s2 * s2};
  }

  QuadraturePointCounts quadrature_point_counts(int order, double level_over_temperature,
                                                ClosureRootSearchStage stage) const override {
    if (stage == ClosureRootSearchStage::rough)
      return {16 + 2 * order, 20 + 2 * order, 20 + 2 * order};
    // The number of quadrature points increases more slowly than the width of the domain, since the
    // density is small in the added part of a wider domain.
    const double deviations = std::sqrt(2 * level_over_temperature);
    const double width = std::pow(deviations / kLevelDeviations[0], 0.75);
    const auto widened = [&](int points) {
      // The factor 1 + kRounding prevents the loss of a quadrature point by rounding if the
      // relative width of the domain is 1
      constexpr double kRounding = 1e-9;
      return static_cast<int>(points * width * (1 + kRounding));
    };
    const int v = widened(32 + 2 * order);
    return {widened(24 + 2 * order), v, v};
  }

 private:
  // Candidates for the confinement level in standard deviations of v, for a density exp(-h/T) of
  // the energy h with T = E[v^2].
  static constexpr std::array kLevelDeviations{6.5, 5.2, 8.0};
  static constexpr double kFarthestDeviations = 16;

  LinearisedFormulation(const problem::Problem& problem, const ClosureOptions& options,
                        const problem::MotionScales& scales)
      : MomentFormulation(problem, options, scales.velocity_deviation * scales.velocity_deviation),
        scales_(scales) {}

  std::vector<double> candidate_levels(const ClosureDensity& guess) const override {
    std::vector<double> levels;
    for (const double deviations : kLevelDeviations)
      levels.push_back(guess.temperature * depth_at_deviations(deviations));
    return levels;
  }
  std::pair<double, double> energy_scan_range(double from,
                                              const ClosureDensity& guess) const override {
    return {from, guess.temperature * depth_at_deviations(kFarthestDeviations)};
  }

  problem::MotionScales scales_;
};

// Root search from the energy-averaged density. The root search at the lowest closure order starts
// from the energy-averaged density. At a higher closure order the search starts from the
// energy-averaged density if the search from the next lower order finds no root.
class EnergyAveragedFormulation final : public MomentFormulation {
 public:
  EnergyAveragedFormulation(const problem::Problem& problem, const ClosureOptions& options)
      : EnergyAveragedFormulation(problem, options, EnergyAveragedExponent(problem)) {}

  // The energy-averaged density as initial guess has no polynomial Q_n; exponent_of_initial_guess()
  // evaluates its exponent.
  ClosureDensity initial_density() const override {
    return {.temperature = averaged_.temperature()};
  }
  // The lowest closure order is 4, since a Gaussian density (order 2) cannot be ring-shaped.
  int lowest_searched_order(int order) const override { return std::min(order, 4); }
  bool can_start_at_any_order() const override { return true; }

  QuadraturePointCounts quadrature_point_counts(int order, double level_over_temperature,
                                                ClosureRootSearchStage stage) const override {
    const double width = std::max(1.0, std::sqrt(2 * level_over_temperature) / kDeviations[0]);
    const int least = stage == ClosureRootSearchStage::rough ? 20 : 32;
    const auto widened = [&](int points) { return static_cast<int>(points * std::sqrt(width)); };
    return {widened(least + 8 + 2 * order), widened(least + 2 * order), widened(least + 2 * order)};
  }

  double exponent_of_initial_guess(const ClosureDensity& guess, double y, double v) const override {
    return guess.q.terms().empty() ? averaged_(y, v) : guess.q(y, v);
  }

  // The fit of the exponent to the energy-averaged density has weights that are a small power of
  // this density. With a small power of the density as weight, the fit also covers large energies,
  // where the polynomial Q_n might rise.
  Eigen::VectorXd weights_of_exponent_fit(const ClosureDensity& guess, double,
                                          const QuadraturePoints& points,
                                          const Eigen::VectorXd& exponent,
                                          const Eigen::VectorXd& mass) const override {
    if (!guess.q.terms().empty()) return mass;
    constexpr double kFlatter = 1.0 / 3;
    const Eigen::VectorXd flat =
        points.weight.array() * (kFlatter * (exponent.array() - exponent.maxCoeff())).exp();
    return flat / flat.sum();
  }

  double decay_ratio(const ClosureDensity& closure, ClosureRootSearchStage stage) const override {
    const double ratio = MomentFormulation::decay_ratio(closure, stage);
    if (stage == ClosureRootSearchStage::rough) return ratio;
    return std::max(ratio, density_ratio_at_confinement_level(closure, problem_) *
                               (kMaxSupportEdgeDensity / kPreferredLevelDensity));
  }

 private:
  // Candidates for the confinement level, given as numbers d: the level is the energy at which the
  // exponent -Phi of the energy-averaged density is -d^2/2. A Gaussian density has the exponent
  // -d^2/2 at a distance of d standard deviations from its peak.
  static constexpr std::array kDeviations{6.5, 7.2, 5.2, 8.0};
  // Largest energy in the scan of the exponent Q_n, relative to the first confinement level.
  static constexpr double kLargestScanRatio = 8;
  // Smallest values of the confinement level, in units of the 95 % quantile of the energy. The
  // confinement term (energy / level)^16 at the 95 % quantile of the energy is then at most 5e-4
  // for kAboveBulk and 4e-8 for kFarAboveBulk.
  static constexpr double kAboveBulk = 1.6, kFarAboveBulk = 2.9;
  // Lower limit of the confinement level, in units of the energy of the highest potential barrier.
  static constexpr double kAboveBarrier = 1.3;

  EnergyAveragedFormulation(const problem::Problem& problem, const ClosureOptions& options,
                            EnergyAveragedExponent averaged)
      : MomentFormulation(problem, options, averaged.temperature()),
        averaged_(std::move(averaged)) {}

  std::vector<double> candidate_levels(const ClosureDensity& guess) const override {
    const double least = std::max(kAboveBulk * averaged_.energy_of_95_percent_quantile(),
                                  kAboveBarrier * averaged_.barrier_energy());
    const double warmer = std::clamp(guess.temperature / averaged_.temperature(), 0.5, 2.0);
    std::vector<double> levels;
    for (const double deviations : kDeviations) {
      levels.push_back(std::max(
          least, warmer * averaged_.energy_at_exponent_decrease(depth_at_deviations(deviations))));
    }
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
  }
  std::pair<double, double> energy_scan_range(double from, const ClosureDensity&) const override {
    return {std::max(from, kFarAboveBulk * averaged_.energy_of_95_percent_quantile()),
            kLargestScanRatio *
                averaged_.energy_at_exponent_decrease(depth_at_deviations(kDeviations[0]))};
  }

  EnergyAveragedExponent averaged_;
};

}  // namespace

std::unique_ptr<half_plane::ClosureFormulation> make_formulation(const problem::Problem& problem,
                                                                 const ClosureOptions& options) {
  if (starts_from_equivalent_linearisation(problem)) {
    return std::make_unique<LinearisedFormulation>(problem, options);
  }
  return std::make_unique<EnergyAveragedFormulation>(problem, options);
}

half_plane::ClosureRootSearchResult find_closure_root(const problem::Problem& problem,
                                                      const ClosureOptions& options) {
  return half_plane::find_closure_root(*make_formulation(problem, options), options);
}

}  // namespace fpkcheck::epc::moment
