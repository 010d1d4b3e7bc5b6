#include <gtest/gtest.h>

#include <cmath>

#include "closures.hpp"
#include "epc/gaussian/projected_equations.hpp"
#include "epc/selection_policy.hpp"
#include "epc/solve.hpp"
#include "exact/closed_forms.hpp"
#include "paper_cases.hpp"
#include "problem/balances.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using transform::Status;

tests::Coefficients coefficients(const ClosureResult& result) {
  return tests::coefficients_by_power(result.summary);
}

// Coefficients in units of the deviations, where their magnitudes are comparable.
tests::Coefficients scaled_coefficients(const ClosureResult& result,
                                        const problem::Problem& problem) {
  const auto [s1, s2] = gaussian_weight_deviations(problem);
  return tests::scaled_coefficients_by_power(result.summary, s1, s2);
}

TEST(GaussianClosure, OrderTwoIsEquivalentLinearisation) {
  for (int number = 1; number <= 4; ++number) {
    const problem::Problem p = tests::paper_case(number);
    const auto linear = problem::equivalent_linearisation(p);
    const ClosureResult result = solve_closure(p, {.order = 2});
    const auto a = coefficients(result);
    EXPECT_EQ(result.solution.status, Status::ok) << result.solution.reason;
    EXPECT_NEAR(a.at({2, 0}) * -2 * std::pow(linear.displacement_deviation, 2), 1, 1e-10);
    EXPECT_NEAR(a.at({0, 2}) * -2 * std::pow(linear.velocity_deviation, 2), 1, 1e-10);
    EXPECT_NEAR(a.at({1, 1}), 0, 1e-10);
    EXPECT_EQ(result.summary.iterations, 1);  // the start is the root; one step polishes it
    EXPECT_NEAR(result.solution.moments.v2 / std::pow(linear.velocity_deviation, 2), 1, 1e-9);
    // The impact loss of a Gaussian equals that of the linearised damping.
    EXPECT_NEAR(result.solution.energy_residual, 0, 1e-9);
  }
}

TEST(GaussianClosure, WhiteNoiseWithoutLossGivesTheExactDensityFromOrderFourOn) {
  const problem::Problem p = tests::make_problem(
      {.damping = 0.2, .stiffness = 1.3, .cubic = 0.6, .restitution = 1, .intensity = 0.3});
  const exact::WhiteNoiseDensity exact(p);
  const double beta = 0.2 / (0.3 / 2);
  for (const int order : {4, 6, 8, 12}) {
    for (const MonomialSet set : {MonomialSet::point_symmetric, MonomialSet::general}) {
      const ClosureResult result =
          solve_closure(p, {.order = order, .monomials = set, .equation = DensityEquation::white});
      ASSERT_EQ(result.solution.status, Status::ok) << result.solution.reason;
      for (const auto& [power, a] : coefficients(result)) {
        const double expected = power == std::pair{2, 0}   ? -beta * 1.3 / 2
                                : power == std::pair{0, 2} ? -beta / 2
                                : power == std::pair{4, 0} ? -beta * 0.6 / 4
                                                           : 0;
        EXPECT_NEAR(a, expected, 1e-10) << power.first << ' ' << power.second << " n " << order;
      }
      const auto& density = std::get<transform::SmoothDensity>(*result.solution.density);
      // The density on the physical half-plane is twice that on the (z, z') plane.
      EXPECT_NEAR(density.value(0.4, -0.7), 2 * exact(0.4, -0.7), 1e-10);
      EXPECT_NEAR(result.solution.moments.v2, exact::mean_square_velocity(p), 1e-9);
      EXPECT_NEAR(result.solution.energy_residual, 0, 1e-9);
      EXPECT_TRUE(result.summary.leading_form->negative);
    }
  }
}

TEST(GaussianClosure, PaperCasesAtOrderSixAreDensities) {
  for (int number = 1; number <= 4; ++number) {
    const ClosureResult result = solve_closure(tests::paper_case(number), {.order = 6});
    const auto& [solution, summary] = result;
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_TRUE(solution.reason.empty());
    EXPECT_LT(summary.residual, 1e-12);
    EXPECT_LE(summary.iterations, 8);
    EXPECT_NEAR(solution.mass, 1, 1e-8);
    EXPECT_LT(summary.support->edge_density, 1e-6);
    EXPECT_LT(summary.support->cut_off, 1e-8);
    EXPECT_LT(std::abs(solution.energy_residual), 0.01);
    // docs/theory.md, section 5: (19) is violated along x1 in cases 2 to 4.
    EXPECT_EQ(summary.leading_form->negative, number == 1);
    EXPECT_EQ(coefficients(result).at({6, 0}) > 0, number != 1);
    EXPECT_LT(coefficients(result).at({0, 6}), 0);
  }
}

TEST(GaussianClosure, PaperCasesAtOrderFourAreRootsButNoDensities) {
  for (int number = 1; number <= 4; ++number) {
    const ClosureResult result = solve_closure(tests::paper_case(number), {.order = 4});
    const auto& [solution, summary] = result;
    EXPECT_EQ(solution.status, Status::inadmissible);
    EXPECT_NE(solution.reason.find("edge"), std::string::npos) << solution.reason;
    EXPECT_LT(summary.residual, 1e-12);
    EXPECT_LE(summary.iterations, 9);
    EXPECT_GT(summary.support->edge_density, 1e-4);
    EXPECT_FALSE(summary.leading_form->negative);
    EXPECT_GT(coefficients(result).at({0, 4}), 0);
    EXPECT_EQ(coefficients(result).at({4, 0}) > 0, number == 1);
    // The density on the set where Q_n falls is still returned.
    ASSERT_TRUE(solution.density.has_value());
    EXPECT_NEAR(solution.mass, 1, 1e-4);
  }
}

TEST(GaussianClosure, OrderEightOfThePaperCasesIsNotOk) {
  for (int number = 1; number <= 4; ++number) {
    const auto [solution, summary] = solve_closure(tests::paper_case(number), {.order = 8});
    EXPECT_NE(solution.status, Status::ok) << number;
    EXPECT_EQ(summary.plain_newton_converges, number == 4);
    EXPECT_FALSE(solution.reason.empty());
    EXPECT_EQ(solution.reason.find('\n'), std::string::npos);
    if (solution.status == Status::not_converged) {
      EXPECT_GT(summary.residual, 1e-10);
      EXPECT_FALSE(solution.density.has_value());
      EXPECT_TRUE(summary.coefficients.empty());
    }
  }
}

TEST(GaussianClosure, ASpuriousRootThatFallsProperlyIsNamedByItsEnergyBalance) {
  // For rare impulses the density of the root at n = 6 is unimodal and dissipates twice the input.
  const auto [solution, summary] = solve_closure(tests::make_problem({.rate = 0.3}), {.order = 6});
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_LT(summary.residual, 1e-10);
  EXPECT_LT(summary.support->edge_density, 1e-6);
  EXPECT_LT(solution.energy_residual, -0.9);
  EXPECT_NE(solution.reason.find("balance of power"), std::string::npos);
}

TEST(GaussianClosure, AgreesWithTheJumpEquationWhereImpulsesAreFrequent) {
  // Reference: `kf` with r = 1, rate 10, by an independent spectral computation.
  const problem::Problem p = tests::make_problem({.restitution = 1, .rate = 10});
  const auto [solution, summary] = solve_closure(p, {.order = 8});
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_NEAR(solution.moments.y2, 0.44410, 2e-5);
  EXPECT_NEAR(solution.moments.y4, 0.55904, 5e-5);
  EXPECT_NEAR(solution.moments.v2, 0.5, 1e-5);
  EXPECT_NEAR(solution.moments.v4, 0.7558, 1e-4);
}

TEST(GaussianClosure, EnergyResidualIsThatOfTheDensityReturned) {
  const problem::Problem p = tests::make_problem({.restitution = 0.9, .mean = 0.2});
  const auto solution = solve_closure(p, {.order = 6}).solution;
  const auto& density = std::get<transform::SmoothDensity>(*solution.density);
  const auto& m = solution.moments;
  ASSERT_GT(std::abs(m.v1), 1e-6);
  EXPECT_DOUBLE_EQ(solution.energy_residual,
                   problem::power_balance_residual(
                       p, {.mean_velocity = m.v1,
                           .mean_square_velocity = m.v2,
                           .left_impact_loss = (1 - 0.9) * flux_into_left_wall(density, 3)}));
}

TEST(GaussianClosure, OrderEightIsReachedWhereImpulsesAreFrequent) {
  const problem::Problem p = tests::make_problem({.rate = 10});
  const ClosureResult six = solve_closure(p, {.order = 6}), eight = solve_closure(p, {.order = 8});
  EXPECT_EQ(eight.solution.status, Status::ok) << eight.solution.reason;
  EXPECT_NEAR(eight.solution.moments.y2, six.solution.moments.y2, 2e-4);
  EXPECT_NEAR(eight.solution.moments.v2, six.solution.moments.v2, 2e-4);
}

TEST(GaussianClosure, FollowsTheBranchWherePlainNewtonStepsAreLost) {
  const problem::Problem p = tests::make_problem({.restitution = 0.5});
  const ClosureResult result = solve_closure(p, {.order = 4});
  EXPECT_FALSE(result.summary.plain_newton_converges);
  EXPECT_GT(result.summary.iterations, 30);
  EXPECT_LT(result.summary.residual, 1e-10);
  EXPECT_NE(result.solution.status, Status::not_converged) << result.solution.reason;
}

// z -> a z maps (mu, lambda E[Y^2]) to (mu/a^2, a^2 lambda E[Y^2]): case 3 is case 2 with
// a^2 = 1/10, and a_pq(case 3) = a_pq(case 2) 10^((p+q)/2).
TEST(GaussianClosure, CaseThreeIsCaseTwoInOtherUnits) {
  for (const int order : {4, 6}) {
    const ClosureResult two = solve_closure(tests::paper_case(2), {.order = order});
    const ClosureResult three = solve_closure(tests::paper_case(3), {.order = order});
    const auto a = coefficients(two), b = coefficients(three);
    for (const auto& [power, value] : a) {
      const double expected = value * std::pow(10, (power.first + power.second) / 2.0);
      EXPECT_NEAR(b.at(power), expected, 1e-9 * std::abs(expected) + 1e-12);
    }
    EXPECT_NEAR(three.solution.moments.y2 * 10, two.solution.moments.y2, 1e-7);
  }
}

TEST(GaussianClosure, TheGeneralSetGivesThePointSymmetricSolutionWhateverTheMean) {
  for (const double mean : {0.0, 0.1, -0.15}) {
    const problem::Problem p = tests::make_problem({.mean = mean});
    for (const int order : {2, 4, 6}) {
      const ClosureResult half = solve_closure(p, {.order = order});
      const ClosureResult whole =
          solve_closure(p, {.order = order, .monomials = MonomialSet::general});
      ASSERT_NE(half.solution.status, Status::not_converged);
      EXPECT_EQ(half.solution.status, whole.solution.status);
      const auto a = scaled_coefficients(half, p);
      for (const auto& [power, value] : scaled_coefficients(whole, p)) {
        const double expected = (power.first + power.second) % 2 == 0 ? a.at(power) : 0;
        EXPECT_NEAR(value, expected, 1e-10) << power.first << ' ' << power.second;
      }
      EXPECT_NEAR(whole.solution.moments.y2, half.solution.moments.y2, 1e-9);
    }
  }
}

TEST(GaussianClosure, AnOutwardMeanPushesTheResponseOutwards) {
  const auto y1 = [](double mean) {
    return solve_closure(tests::make_problem({.mean = mean}), {.order = 6}).solution.moments.y1;
  };
  EXPECT_GT(y1(0.1), y1(0) + 0.02);
  EXPECT_LT(y1(-0.1), y1(0) - 0.02);
}

TEST(GaussianClosure, ReportsAPointWhereTheEquationsAreMetIndependently) {
  const problem::Problem p = tests::paper_case(4);
  const ClosureResult result = solve_closure(p, {.order = 6});
  const ProjectedEquations projection(
      GaussianWeightedBasis(6, MonomialSet::general, gaussian_weight_deviations(p)));
  const Eigen::VectorXd residual =
      projection.residual(residual_coefficients(p, DensityEquation::km4),
                          projection.basis().scaled_coefficients(result.summary.coefficients));
  EXPECT_LT(residual.norm(), 1e-12);
}

TEST(GaussianClosure, ReasonStatesTheProbabilityCutOff) {
  const auto [solution, summary] = solve_closure(tests::paper_case(1), {.order = 4});
  EXPECT_NE(solution.reason.find("cuts off about 5.2e-04"), std::string::npos) << solution.reason;
  EXPECT_NE(solution.reason.find("from radius"), std::string::npos);
}

TEST(GaussianClosure, ConvergesNearlyWithoutDamping) {
  // The intensity is proportional to the damping: E[v^2] is 0.5 as for damping 0.1.
  for (const double damping : {1e-5, 1e-7}) {
    const auto solution =
        solve_closure(tests::make_problem(
                          {.damping = damping, .restitution = 1, .rate = 1, .intensity = damping}),
                      {.order = 4})
            .solution;
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_NEAR(solution.moments.v2, 0.5, 1e-4);
  }
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
