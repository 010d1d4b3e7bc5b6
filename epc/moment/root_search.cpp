#include "epc/moment/root_search.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "epc/form/acceptance_limits.hpp"
#include "epc/half_plane/norms.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/moment/contour_decay.hpp"
#include "epc/moment/density_at_level.hpp"
#include "epc/moment/energy_averaged_formulation.hpp"
#include "epc/moment/equations.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::moment {
namespace {

using half_plane::Basis;
using half_plane::ClosureDensity;
using half_plane::Confinement;
using half_plane::QuadraturePoints;
using half_plane::QuadratureRefinement;
using half_plane::QuadratureSize;
using half_plane::SearchStage;

// Candidates for the confinement level in deviations of v, for a density exp(-h/T) with T = E[v^2],
// in the order of the attempts.
constexpr std::array kLevelDeviations{6.5, 5.2, 8.0};
constexpr double kFarthestDeviations = 16;

double level_of(const ClosureDensity& closure, double deviations) {
  return closure.temperature * deviations * deviations / 2;
}

// Products lambda E[Y^j], j = 0 .. n; 0 for terms that are absent from the equation.
std::vector<double> rate_moments(const problem::Problem& problem, const Options& options) {
  std::vector<double> moments(options.order + 1);
  const int last = equation_of(options) == Equation::white ? 2 : options.order;
  for (int j = 1; j <= last; ++j) moments[j] = problem.impulses.rate_times_moment(j);
  return moments;
}

// Formulation for the paper's oscillator, started from equivalent linearisation.
class LinearisedFormulation : public half_plane::ClosureFormulation {
 public:
  LinearisedFormulation(const problem::Problem& problem, const Options& options)
      : problem_(problem), tail_(options.tail), rate_moment_(rate_moments(problem, options)) {}

  ClosureDensity initial_density() const override {
    const auto linear = problem::equivalent_linearisation(problem_);
    const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
    const double centre = problem::static_deflection(problem_);
    return {
        .q = Polynomial(
            {{1, 0, centre / (s1 * s1)}, {2, 0, -1 / (2 * s1 * s1)}, {0, 2, -1 / (2 * s2 * s2)}}),
        .temperature = s2 * s2};
  }

  double rate_of_change_unit() const override { return half_plane::rate_of_change_unit(problem_); }

  std::vector<double> confinement_levels(const ClosureDensity& guess,
                                         SearchStage stage) const override {
    std::vector<double> confinement_levels;
    for (const double deviations : kLevelDeviations)
      confinement_levels.push_back(level_of(guess, deviations));
    if (stage == SearchStage::rough) return confinement_levels;
    const auto whole = negligible_level(guess, confinement_levels.front(), guess);
    if (whole) confinement_levels.insert(confinement_levels.begin(), *whole);
    return confinement_levels;
  }

  std::optional<double> improved_confinement_level(const ClosureDensity& guess,
                                                   const ClosureDensity& closure) const override {
    const auto whole = negligible_level(closure, closure.level, guess);
    return whole && *whole > kMinLevelRatio * closure.level ? whole : std::nullopt;
  }

  QuadratureSize quadrature_size(int order, double level_over_temperature,
                                 SearchStage stage) const override {
    if (stage == SearchStage::rough) return {16 + 2 * order, 20 + 2 * order, 20 + 2 * order};
    // The number of points grows more slowly than the width of the domain: in the added part of a
    // wider domain the density is small.
    const double deviations = std::sqrt(2 * level_over_temperature);
    const double width = std::pow(deviations / kLevelDeviations[0], 0.75);
    const auto widened = [&](int points) {
      constexpr double kRounding = 1e-9;  // a width of 1 must not lose a point by rounding
      return static_cast<int>(points * width * (1 + kRounding));
    };
    const int v = widened(32 + 2 * order);
    return {widened(24 + 2 * order), v, v};
  }

  QuadratureRefinement quadrature_refinement() const override {
    return {QuadratureRefinement::ChangeMeasure::estimated, 1e-9};
  }

  QuadraturePoints points_below_energy(double support, const QuadratureSize& size) const override {
    return EnergyDomain(problem_, support).quadrature_points(size.s, size.t);
  }

  half_plane::ClosureEquations closure_equations(double support, const Confinement& confinement,
                                                 Basis basis, QuadraturePoints points,
                                                 const QuadratureSize& size) const override {
    return moment::closure_equations(problem_, rate_moment_, EnergyDomain(problem_, support),
                                     confinement, std::move(basis), std::move(points), size.wall);
  }

  // Decay ratio at the confinement level for intermediate orders, and at the edge of the support
  // for the requested order.
  double decay_ratio(const ClosureDensity& closure, SearchStage stage) const override {
    return stage == SearchStage::rough ? density_ratio_at_level(closure, problem_)
                                       : density_ratio_at_edge(closure, problem_, tail_);
  }
  double decay_ratio_limit(SearchStage stage) const override {
    return stage == SearchStage::rough ? kIntermediateLevelDensity : kEdgeDensityLimit;
  }

 private:
  // Energy at which the Q_n of a density lies kNegligibleDepth below its peak; empty if there is no
  // such energy up to kFarthestDeviations of the guess.
  std::optional<double> negligible_level(const ClosureDensity& closure, double from,
                                         const ClosureDensity& guess) const {
    return scan_decay(closure.q, problem_, from, level_of(guess, kFarthestDeviations),
                      kNegligibleDepth)
        .crossing;
  }

  const problem::Problem& problem_;
  TailTreatment tail_;
  std::vector<double> rate_moment_;
};

}  // namespace

half_plane::RootSearchResult find_root(const problem::Problem& problem, const Options& options) {
  if (problem::has_equivalent_linearisation(problem)) {
    return half_plane::find_root(LinearisedFormulation(problem, options), options);
  }
  return half_plane::find_root(
      EnergyAveragedFormulation(problem, options, rate_moments(problem, options)), options);
}

}  // namespace fpkcheck::epc::moment
