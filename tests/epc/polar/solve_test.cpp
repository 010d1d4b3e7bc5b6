#include "epc/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "closures.hpp"
#include "exact/closed_forms.hpp"
#include "paper_cases.hpp"
#include "random_problem.hpp"
#include "thorough.hpp"

namespace fpkcheck::epc {
namespace {

using tests::make_problem;
using tests::paper_case;
using transform::Status;

ClosureOptions polar_options(int order) {
  return tests::closure_options(Formulation::polar, order);
}

class PolarCase : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Each, PolarCase, testing::Values(1, 2, 3, 4));

TEST_P(PolarCase, EveryOrderConverges) {
  const auto p = paper_case(GetParam());
  for (int order = 2; order <= 10; order += 2) {
    const auto [solution, summary] = solve_closure(p, polar_options(order));
    EXPECT_EQ(solution.status, Status::ok) << order << ": " << solution.reason;
    EXPECT_LT(summary.residual, 1e-10) << order;
    EXPECT_NEAR(solution.mass, 1, 1e-5) << order;
    // The basis contains rho^2/2: every order satisfies the energy balance.
    EXPECT_LT(std::abs(solution.energy_residual), 1e-6) << order;
    // The basis does not contain v: E[v] tends to 0 with growing order.
    if (order >= 8) {
      EXPECT_NEAR(solution.moments.v1, 0, 1e-6 * std::sqrt(solution.moments.v2));
    }
    EXPECT_LT(summary.half_plane->quadrature_change, 1e-5) << order;
    EXPECT_LT(summary.condition.value(), 1e3) << order;
  }
}

// Reference: docs/reference.md, case 1 by finite volumes on three grids, with an error of 2e-8.
TEST(PolarClosure, HasTheReferenceMomentsOfCaseOne) {
  const auto moments = solve_closure(paper_case(1), polar_options(10)).solution.moments;
  EXPECT_NEAR(moments.y1 / 0.5004370246, 1, 1e-7);
  EXPECT_NEAR(moments.y2 / 0.3945181775, 1, 1e-7);
  EXPECT_NEAR(moments.y4 / 0.4699403458, 1, 1e-6);
  EXPECT_NEAR(moments.v2 / 0.4415122121, 1, 1e-7);
  EXPECT_NEAR(moments.v4 / 0.6344508375, 1, 1e-6);
}

TEST(PolarClosure, CasesTwoAndThreeAreOneProblem) {
  const auto two = solve_closure(paper_case(2), polar_options(6)).solution;
  const auto three = solve_closure(paper_case(3), polar_options(6)).solution;
  EXPECT_NEAR(three.moments.y2 * 10 / two.moments.y2, 1, 1e-6);
  EXPECT_NEAR(three.moments.v4 * 100 / two.moments.v4, 1, 1e-6);
}

// Frequent small impulses tend to white noise: Q_n = -beta rho^2/2 up to the next cumulant, which
// is of order 1/lambda.
TEST(PolarClosure, TendsToTheExactDensityOfWhiteNoise) {
  const auto p = make_problem({.cubic = 0.7, .restitution = 1, .rate = 300, .intensity = 0.4});
  const double beta = 2 * 0.1 / 0.4;
  const auto [solution, summary] = solve_closure(p, polar_options(4));
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  for (const auto& [power, angle, a] : summary.coefficients) {
    const double unit = std::pow(beta, -power / 2.0);
    const double expected = power == 2 && angle == 0 ? -0.5 : 0;
    EXPECT_NEAR(a * unit, expected, 1e-2) << "rho^" << power << " theta^" << angle;
  }
}

// r = 1, any even potential: stationarity of E[rho^2/2] gives E[v^2] = lambda E[Y^2] / (2c).
TEST(PolarClosure, HasTheExactVelocityWithoutLosses) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    for (const double cubic : {0.0, 3.0}) {
      const auto p = make_problem({.cubic = cubic, .restitution = 1, .law = law});
      EXPECT_NEAR(solve_closure(p, polar_options(4)).solution.moments.v2, 0.5, 1e-6)
          << law << cubic;
    }
  }
}

// In the linear process with elastic impacts, the basis does not contain the fourth powers: the
// fourth moments converge with growing order.
TEST(PolarClosure, ConvergesToTheExactMomentsOfTheLinearProcess) {
  for (const char* law : {"gaussian", "laplace"}) {
    const auto p = make_problem({.cubic = 0, .restitution = 1, .law = law});
    const double y2 = exact::linear_cumulant(p, 2, 0), v2 = exact::linear_cumulant(p, 0, 2);
    const double y4 = exact::linear_cumulant(p, 4, 0) + 3 * y2 * y2;
    const double v4 = exact::linear_cumulant(p, 0, 4) + 3 * v2 * v2;
    const auto moments = solve_closure(p, polar_options(8)).solution.moments;
    EXPECT_NEAR(moments.y2 / y2, 1, 2e-5) << law;
    EXPECT_NEAR(moments.y4 / y4, 1, 1e-4) << law;
    EXPECT_NEAR(moments.v4 / v4, 1, 1e-4) << law;
  }
}

// The problems have r from 0.5 to 1, lambda from 0.3 to 18, mu from 0 to 2, every amplitude law,
// and mean impulses of either sign.
TEST(PolarClosure, RandomProblemsConverge) {
  std::mt19937_64 engine(2026);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * std::generate_canonical<double, 53>(engine);
  };
  const char* laws[] = {"gaussian", "laplace", "two_point", "uniform"};
  for (int k = 0; k < tests::part_unless_thorough(16, 40); ++k) {
    const double restitution = uniform(0.5, 1);
    const double rate = 0.3 * std::pow(60, uniform(0, 1));
    const double cubic = uniform(0, 2);
    const double intensity = 0.1 * std::pow(10, uniform(0, 1));
    const double mean = k % 2 == 0 ? 0 : uniform(-0.3, 0.3) * std::sqrt(intensity / rate);
    const auto p = make_problem({.cubic = cubic,
                                 .restitution = restitution,
                                 .rate = rate,
                                 .intensity = intensity,
                                 .mean = mean,
                                 .law = laws[k / 2 % 4]});
    const auto [solution, summary] = solve_closure(p, polar_options(6));
    EXPECT_EQ(solution.status, Status::ok)
        << "problem " << k << ", r = " << restitution << ", lambda = " << rate << ", mu = " << cubic
        << ", mean = " << mean << ": " << solution.reason;
    EXPECT_LT(summary.residual, 1e-10) << k;
    EXPECT_LT(std::abs(solution.energy_residual), 1e-4) << k;
  }
}

// With a quarter of an impulse per decay time, the probability of the guess lies on the edge of the
// domain at every level except the level of the guess.
TEST(PolarClosure, TriesTheLevelOfTheOrderBeforeLast) {
  auto options = polar_options(4);
  options.max_seconds = 600;  // sanitizers need more than the default
  const auto [solution, summary] = solve_closure(tests::random_problem(33), options);
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
}

// Under strong losses the density has a spike at v = 0+ on the wall, narrower than equal panels.
TEST(PolarClosure, HasItsWholeMassOnPanels) {
  for (const int number : {2, 9, 38}) {
    const auto solution = solve_closure(tests::random_problem(number), polar_options(6)).solution;
    EXPECT_NEAR(solution.mass, 1, 1e-5) << number;
  }
}

// The problem has 1/12 impulses per decay time.
TEST(PolarClosure, ReportsTheOrderAtWhichItIsLost) {
  auto options = polar_options(8);
  options.max_iterations = 1;
  const auto [solution, summary] = solve_closure(tests::random_problem(42), options);
  EXPECT_EQ(solution.status, Status::not_converged);
  EXPECT_NE(solution.reason.find("failed at order"), std::string::npos) << solution.reason;
  EXPECT_FALSE(solution.density.has_value());
}

}  // namespace
}  // namespace fpkcheck::epc
