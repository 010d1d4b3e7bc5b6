#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "distances.hpp"
#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::StateVariable;
using transform::Status;

FiniteVolumeOptions along(double refinement = 1) {
  return {.transport = TransportScheme::characteristics, .refinement = refinement};
}

FiniteVolumeOptions on_one_grid() {
  FiniteVolumeOptions options = along();
  options.error_estimate = false;
  return options;
}

double distance(const transform::Marginal& a, const std::vector<double>& exact) {
  double sum = 0;
  for (std::size_t b = 0; b < a.size(); ++b) {
    sum += std::abs(a.density[b] - exact[b]) * a.bin_width(b);
  }
  return sum;
}

// The linear oscillator without losses at the wall has an exact density.
TEST(AlongCharacteristics, MeetsTheExactDensityWithinItsStatedError) {
  const auto p = tests::make_problem({.damping = 0.2, .cubic = 0, .restitution = 1, .rate = 1.3});
  const exact::LinearDensity exact(p);
  const auto y = tests::uniform_edges(0, 4, 80), v = tests::uniform_edges(-3, 3, 120);
  std::vector<double> errors;
  for (const double refinement : {0.5, 1.0, 2.0}) {
    const auto solution = solve_stationary_density(p, along(refinement)).solution;
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    const double of_y = distance(transform::marginal(*solution.density, StateVariable::y, y),
                                 exact.displacement_averages(y));
    const double of_v = distance(transform::marginal(*solution.density, StateVariable::ydot, v),
                                 exact.velocity_averages(v));
    ASSERT_TRUE(solution.error);
    EXPECT_LT(of_y, 1.25 * solution.error->y_l1);
    EXPECT_LT(of_v, 1.25 * solution.error->ydot_l1);
    errors.push_back(of_y + of_v);
  }
  EXPECT_LT(errors[2], 1e-3);
  // Between first and second order.
  EXPECT_GT(errors[0] / errors[2], 4);
  EXPECT_LT(errors[0] / errors[2], 40);
}

// Down to a fifth of an impulse per decay time, where p ~ rho^-1.8 at the origin.
TEST(AlongCharacteristics, HasTheExactCumulantsOfTheLinearOscillatorHoweverRareTheImpulses) {
  for (const auto* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    for (const double rate : {0.02, 0.2}) {
      // Rare impulses for one law with a density and one law with atoms.
      const bool is_usual = (rate < 0.1) == (law[0] == 'l' || law[0] == 't');
      if (!is_usual && !tests::is_thorough()) continue;
      const auto p = tests::make_problem(
          {.damping = 0.2, .cubic = 0, .restitution = 1, .rate = rate, .law = law});
      const auto solution = solve_stationary_density(p, on_one_grid()).solution;
      const double y2 = exact::linear_cumulant(p, 2, 0), v2 = exact::linear_cumulant(p, 0, 2);
      const double y4 = exact::linear_cumulant(p, 4, 0) + 3 * y2 * y2;
      const double v4 = exact::linear_cumulant(p, 0, 4) + 3 * v2 * v2;
      SCOPED_TRACE(std::string(law) + " " + std::to_string(rate));
      EXPECT_NEAR(solution.moments.y2 / y2, 1, 1e-3);
      EXPECT_NEAR(solution.moments.v2 / v2, 1, 1e-3);
      EXPECT_NEAR(solution.moments.y4 / y4, 1, 4e-3);
      EXPECT_NEAR(solution.moments.v4 / v4, 1, 4e-3);
      EXPECT_NEAR(solution.mass, 1, 1e-12);
      EXPECT_GT(solution.min_density, -1e-8);
      EXPECT_LT(std::abs(solution.energy_residual), 2e-3);
    }
  }
}

// Between rare impulses the motion decays by the same ratio in each half-cycle at any amplitude.
// For small amplitudes P(y < b) ~ b^e, with e the impulses per time in which the motion decays by a
// factor e. Innermost cells wider than the bins gave the first two bins 1 and 0.3 of the mass and
// the next a negative mass, and an error of E[y] equal to the momentum residual.
TEST(AlongCharacteristics, DistributeMassNearRestByTheDecayOfTheMotion) {
  const double c = 1e-3, r = 0.9, rate = 1e-4;
  const auto p = tests::make_problem({.damping = c, .cubic = 0, .restitution = r, .rate = rate});
  const auto [solution, summary] =
      solve_stationary_density(p, {.stepper = StationarySolver::direct});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  ASSERT_EQ(summary.transport, TransportScheme::characteristics);
  const double half_cycle = std::numbers::pi / std::sqrt(1 - c * c / 4);
  const double exponent = rate / (c / 2 - std::log(r) / half_cycle);
  // The bins of compare/comparison_bins.cpp: 0.05 standard deviations, divided at 1/4, 1/16 and
  // 1/64.
  const double bin = 0.05 * 0.86;
  const auto y =
      transform::marginal(*solution.density, StateVariable::y,
                          std::vector<double>{0, bin / 64, bin / 16, bin / 4, bin, 2 * bin});
  double below = y.density[0] * y.bin_width(0);
  EXPECT_LT(below, 1);
  for (std::size_t b = 1; b < 4; ++b) {
    const double mass = y.density[b] * y.bin_width(b);
    below += mass;
    EXPECT_NEAR(mass / (below * (1 - std::pow(4, -exponent))), 1, 0.01) << b;
  }
  for (const auto& [variable, end] :
       {std::pair{StateVariable::y, 1.0}, {StateVariable::ydot, 1.0}}) {
    const auto fine = transform::marginal(
        *solution.density, variable,
        tests::uniform_edges(variable == StateVariable::y ? 0 : -end, end, 997));
    for (const double density : fine.density) EXPECT_GE(density, 0);
  }
  EXPECT_LT(std::abs(*summary.balances.momentum), 5e-4);
  // The duration of half-cycles is independent of the amplitude, and the stated error covers the
  // rest.
  ASSERT_TRUE(summary.error);
  EXPECT_NEAR(summary.impact_rate, 1 / half_cycle, 1e-4);
  // Guaranteed bounds of `fpkcheck bounds`.
  const transform::Moments& stated = summary.error->moments;
  EXPECT_GT(solution.moments.y1 + 2 * stated.y1, 0.0470638);
  EXPECT_GT(solution.moments.v2 + 2 * stated.v2, 0.7368703);
  EXPECT_LT(solution.moments.v2 - 2 * stated.v2, 0.7374409);
}

// Compares two independent discretisations of the same problem with losses.
TEST(AlongCharacteristics, AgreesWithTheDifferencesWhereBothResolveTheDensity) {
  const auto y = tests::uniform_edges(0, 2.5, 50);
  for (const double restitution : {0.6, 0.98}) {
    for (const double cubic : {0.0, 2.0}) {
      const auto p = tests::make_problem({.cubic = cubic, .restitution = restitution});
      const auto upwind = solve_stationary_density(
          p, {.stepper = StationarySolver::direct, .transport = TransportScheme::upwind});
      const auto other = solve_stationary_density(p, along());
      ASSERT_EQ(upwind.solution.status, Status::ok) << upwind.solution.reason;
      ASSERT_EQ(other.solution.status, Status::ok) << other.solution.reason;
      const double apart =
          transform::l1_distance(transform::marginal(*upwind.solution.density, StateVariable::y, y),
                                 transform::marginal(*other.solution.density, StateVariable::y, y));
      EXPECT_LT(apart, 2e-3) << restitution << " " << cubic;
      EXPECT_NEAR(other.summary.impact_rate / upwind.summary.impact_rate, 1, 2e-3);
      EXPECT_NEAR(other.solution.moments.v2 / upwind.solution.moments.v2, 1, 1e-3);
    }
  }
}

// Scales the problem by factors that change only the units.
TEST(AlongCharacteristics, DoNotDependOnTheUnits) {
  const auto reference =
      solve_stationary_density(tests::make_problem({.cubic = 0, .rate = 0.05}), on_one_grid());
  const double t = 1e-5, l = 1e3;
  const auto scaled =
      solve_stationary_density(tests::make_problem({.damping = 0.1 / t,
                                                    .stiffness = 1 / (t * t),
                                                    .cubic = 0,
                                                    .rate = 0.05 / t,
                                                    .intensity = 0.1 * l * l / (t * t * t)}),
                               on_one_grid());
  EXPECT_NEAR(scaled.solution.moments.y2 / (l * l), reference.solution.moments.y2, 1e-8);
  EXPECT_NEAR(scaled.solution.moments.v4 * std::pow(t / l, 4), reference.solution.moments.v4, 1e-8);
}

// Wide cells oscillate about a steep tail; the end of the box must not depend on sums in which
// masses of both signs cancel.
TEST(AlongCharacteristics, BoxHoldsTheTailOfImpulsesWithAMean) {
  for (const double mean : {0.0, 0.2, 0.3}) {
    const auto solution =
        solve_stationary_density(tests::make_problem({.mean = mean}), on_one_grid()).solution;
    EXPECT_EQ(solution.status, Status::ok) << mean << ": " << solution.reason;
  }
}

TEST(Solve, ChoosesTheTransportByTheProblem) {
  const auto transport = [](const tests::Parameters& parameters) {
    return solve_stationary_density(tests::make_problem(parameters),
                                    {.stepper = StationarySolver::direct})
        .summary.transport;
  };
  EXPECT_EQ(transport({}), TransportScheme::upwind);
  EXPECT_EQ(transport({.rate = 0.03}), TransportScheme::characteristics);
  EXPECT_EQ(transport({.restitution = 0.2}), TransportScheme::characteristics);
}

TEST(Options, CharacteristicsRequireKfAndImpactMap) {
  const auto refused = [](const FiniteVolumeOptions& options) {
    EXPECT_THROW(validate(options), std::exception);
  };
  refused({.equation = DensityEquation::km4, .transport = TransportScheme::characteristics});
  refused({.impact = ImpactCondition::delta, .transport = TransportScheme::characteristics});
  refused({.transport = TransportScheme::characteristics, .nx = 40});
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
