#include "epc/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "closures.hpp"
#include "exact/closed_forms.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"

namespace fpkcheck::epc {
namespace {

using tests::coefficients_by_power;
using tests::make_problem;
using tests::paper_case;
using transform::Status;

ClosureOptions moment_options(int order, std::optional<DensityEquation> equation = {}) {
  return tests::closure_options(Formulation::moment, order, equation);
}

class MomentCase : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Each, MomentCase, testing::Values(1, 2, 3, 4));

TEST_P(MomentCase, EveryOrderConverges) {
  const auto p = paper_case(GetParam());
  for (int order = 2; order <= max_closure_order(Formulation::moment); order += 2) {
    const auto [solution, summary] = solve_closure(p, moment_options(order));
    EXPECT_EQ(solution.status, Status::ok) << order << ": " << solution.reason;
    EXPECT_LT(summary.residual, 1e-10) << order;
    // Mass and balances use another quadrature, whose panels do not end at the edge of the domain.
    EXPECT_NEAR(solution.mass, 1, 1e-7) << order;
    EXPECT_LT(std::abs(solution.energy_residual), 1e-6) << order;
    EXPECT_LT(std::abs(*summary.balances.virial), 1e-6) << order;
    EXPECT_LT(std::abs(*summary.balances.momentum), 1e-6) << order;
    EXPECT_LT(summary.half_plane->quadrature_change, 1e-8) << order;
    EXPECT_LT(*summary.condition, 1e4) << order;
    EXPECT_EQ(summary.half_plane->homotopies, 0) << order;
  }
}

// docs/theory.md, section 1: p_3(y) = sqrt(10) p_2(sqrt(10) y), an invariance of the whole method.
TEST(MomentClosure, CasesTwoAndThreeAreOneProblem) {
  for (const int order : {4, 8}) {
    const auto two = solve_closure(paper_case(2), moment_options(order));
    const auto three = solve_closure(paper_case(3), moment_options(order));
    EXPECT_NEAR(three.solution.moments.y2 * 10 / two.solution.moments.y2, 1, 1e-10);
    EXPECT_NEAR(three.solution.moments.v4 * 100 / two.solution.moments.v4, 1, 1e-10);
    auto scaled = coefficients_by_power(two.summary);
    for (const auto& [power, a] : coefficients_by_power(three.summary)) {
      const double expected = scaled[power] * std::pow(10, (power.first + power.second) / 2.0);
      EXPECT_NEAR(a, expected, 1e-6 * (1 + std::abs(expected)))
          << "y^" << power.first << " v^" << power.second;
    }
  }
}

TEST(MomentClosure, IsExactForWhiteNoiseAtAnImpactWithoutLoss) {
  const auto p = make_problem({.cubic = 0.7, .restitution = 1, .rate = 2, .intensity = 0.4});
  const double beta = 2 * 0.1 / 0.4;
  const std::map<std::pair<int, int>, double> exact{
      {{2, 0}, -beta / 2}, {{0, 2}, -beta / 2}, {{4, 0}, -beta * 0.7 / 4}};
  for (const int order : {4, 6, 8}) {
    const auto [solution, summary] =
        solve_closure(p, moment_options(order, DensityEquation::white));
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    const double tolerance = order == 4 ? 1e-10 : 1e-8;
    const double s1 = std::sqrt(solution.moments.y2), s2 = std::sqrt(solution.moments.v2);
    for (const auto& [power, a] : coefficients_by_power(summary)) {
      const double unit = std::pow(s1, power.first) * std::pow(s2, power.second);
      const double expected = exact.contains(power) ? exact.at(power) : 0;
      EXPECT_NEAR(a * unit, expected * unit, tolerance)
          << order << ": y^" << power.first << " v^" << power.second;
    }
  }
}

// The equations for the even moments of the linear system with elastic impacts are closed. n = 4
// gives the second and fourth moments of the compound Poisson process exactly, n = 6 also the
// sixth.
TEST(MomentClosure, GivesTheExactMomentsOfTheLinearProcess) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    const auto p = make_problem({.cubic = 0, .restitution = 1, .law = law});
    const double y2 = exact::linear_cumulant(p, 2, 0), v2 = exact::linear_cumulant(p, 0, 2);
    const double y4 = exact::linear_cumulant(p, 4, 0) + 3 * y2 * y2;
    const double v4 = exact::linear_cumulant(p, 0, 4) + 3 * v2 * v2;
    const double v6 = exact::linear_cumulant(p, 0, 6) + 15 * exact::linear_cumulant(p, 0, 4) * v2 +
                      15 * v2 * v2 * v2;
    for (const int order : {4, 6, 8}) {
      const auto [solution, summary] = solve_closure(p, moment_options(order));
      EXPECT_EQ(solution.status, Status::ok) << law << ": " << solution.reason;
      EXPECT_NEAR(solution.moments.y2 / y2, 1, 1e-8) << law << order;
      EXPECT_NEAR(solution.moments.v2 / v2, 1, 1e-8) << law << order;
      EXPECT_NEAR(solution.moments.y4 / y4, 1, 1e-7) << law << order;
      EXPECT_NEAR(solution.moments.v4 / v4, 1, 1e-7) << law << order;
      if (order >= 6) {
        const auto& density = std::get<transform::SmoothDensity>(*solution.density);
        const double sixth =
            transform::expectation(density, [](double, double v) { return std::pow(v, 6); });
        EXPECT_NEAR(sixth / v6, 1, 1e-6) << law << order;
      }
    }
  }
}

// r = 1, any even potential, E[Y] = 0: E[v^2] = lambda E[Y^2] / (2c).
TEST(MomentClosure, HasTheExactVelocityWithoutLosses) {
  const auto p = make_problem({.cubic = 3, .restitution = 1, .law = "laplace"});
  EXPECT_NEAR(solve_closure(p, moment_options(6)).solution.moments.v2, 0.5, 1e-8);
}

TEST(MomentClosure, ConvergesWithAMeanOfEitherSign) {
  for (const double mean : {-0.2, 0.2}) {
    const auto p = make_problem({.restitution = 0.9, .mean = mean});
    const auto [solution, summary] = solve_closure(p, moment_options(6));
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_LT(std::abs(solution.energy_residual), 1e-6);
    // Stationarity of E[y] requires E[v] = 0.
    EXPECT_NEAR(solution.moments.v1, 0, 1e-7);
  }
  // Far from the wall the linear oscillator has the mean lambda E[Y] / k and E[v^2] without a wall.
  const auto held = make_problem({.cubic = 0, .rate = 1000, .intensity = 0.1, .mean = 0.008});
  const auto [solution, summary] = solve_closure(held, moment_options(4));
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_NEAR(solution.moments.y1, 8, 1e-6);
  EXPECT_NEAR(solution.moments.v2, 0.1 / 0.2, 1e-6);
}

// The problems have r from 0.7 to 1, lambda from 0.5 to 20, mu from 0 to 2, intensities from 0.1 to
// 1.
TEST(MomentClosure, RandomProblemsConvergeAtEveryOrder) {
  std::mt19937_64 engine(2026);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * std::generate_canonical<double, 53>(engine);
  };
  for (int k = 0; k < tests::part_unless_thorough(14, 40); ++k) {
    const double restitution = uniform(0.7, 1);
    const double rate = 0.5 * std::pow(40, uniform(0, 1));
    const double cubic = uniform(0, 2);
    const double intensity = 0.1 * std::pow(10, uniform(0, 1));
    const auto p = make_problem({.cubic = cubic,
                                 .restitution = restitution,
                                 .rate = rate,
                                 .intensity = intensity,
                                 .law = k % 2 == 0 ? "gaussian" : "laplace"});
    for (int order = 2; order <= 8; order += 2) {
      const auto [solution, summary] = solve_closure(p, moment_options(order));
      EXPECT_EQ(solution.status, Status::ok)
          << "problem " << k << ", r = " << restitution << ", lambda = " << rate
          << ", mu = " << cubic << ", n = " << order << ": " << solution.reason;
      EXPECT_LT(summary.residual, 1e-10);
    }
  }
}

// The distance to order n - 2 estimates the error of that order without another method. Reference:
// n = 12, whose error is smaller by a factor.
TEST(MomentClosure, TheDistanceToTheOrderBeforeMeasuresTheErrorThere) {
  const auto p = paper_case(1);
  const auto fine = solve_closure(p, moment_options(12)).solution;
  const auto edges = [](double from, double to) {
    std::vector<double> result;
    for (int i = 0; i <= 200; ++i) result.push_back(from + (to - from) * i / 200);
    return result;
  };
  const auto l1 = [&](const transform::Solution& a) {
    double sum = 0;
    for (const auto variable : {transform::StateVariable::y, transform::StateVariable::ydot}) {
      const auto bins = variable == transform::StateVariable::y ? edges(0, 4) : edges(-4, 4);
      const auto pa = transform::marginal(a, variable, bins);
      const auto pb = transform::marginal(fine, variable, bins);
      for (std::size_t b = 0; b < pa.size(); ++b) {
        sum += std::abs(pa.density[b] - pb.density[b]) * pa.bin_width(b);
      }
    }
    return sum;
  };
  EXPECT_FALSE(solve_closure(p, moment_options(2)).summary.distance_to_previous.has_value());
  for (const int order : {4, 6, 8}) {
    const double before = l1(solve_closure(p, moment_options(order - 2)).solution);
    const auto here = solve_closure(p, moment_options(order));
    EXPECT_GT(*here.summary.distance_to_previous, 0.5 * before) << order;
    EXPECT_LT(*here.summary.distance_to_previous, 1.5 * before) << order;
    EXPECT_LT(l1(here.solution), *here.summary.distance_to_previous) << order;
  }
}

// The frequencies of the motion are about 1: relative to a damping of 1e-7 the residual is rounding
// error.
TEST(MomentClosure, ConvergesAtTheLeastDamping) {
  const auto p = make_problem({.damping = 1e-7, .restitution = 1, .intensity = 1e-7});
  const auto [solution, summary] = solve_closure(p, moment_options(8));
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_NEAR(solution.moments.v2, 0.5, 1e-5);
}

TEST(MomentClosure, ReasonStatesTheDensityAtTheEdgeOfACut) {
  auto options = moment_options(4);
  options.tail = DensityTailTreatment::cut;
  const auto [solution, summary] = solve_closure(paper_case(1), options);
  EXPECT_EQ(solution.id(), "epc-moment-cut-n4");
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_NE(solution.reason.find("of its peak on the edge"), std::string::npos) << solution.reason;
  EXPECT_FALSE(summary.leading_form->negative);
  EXPECT_GT(summary.leading_form->rises_from, 3);
  EXPECT_LT(summary.residual, 1e-10);
  EXPECT_FALSE(summary.coefficients.empty());
  EXPECT_TRUE(solution.density.has_value());
}

// The confinement gives the same Q_n a tail with little probability.
TEST(MomentClosure, AConfinementMakesTheTailDecay) {
  const auto [solution, summary] = solve_closure(paper_case(1), moment_options(4));
  EXPECT_EQ(solution.status, Status::ok);
  EXPECT_FALSE(summary.leading_form->negative);  // Q_n itself rises
  EXPECT_LT(summary.support->edge_density, 1e-6);
  EXPECT_LT(summary.half_plane->beyond_level, 1e-3);
}

// If Q_n falls by itself, the confinement level is an energy at which the density has decayed to
// rounding; the confinement then has no effect.
TEST(MomentClosure, TheConfinementHasNoEffectOnAFallingExponent) {
  const auto [solution, summary] = solve_closure(paper_case(1), moment_options(6));
  EXPECT_TRUE(summary.leading_form->negative);
  EXPECT_GT(summary.half_plane->level_deviations, 9);
  EXPECT_LT(summary.half_plane->beyond_level, 1e-15);
}

// Problem with strong impact losses, and a mean impulse towards the wall.
TEST(MomentClosure, AHomotopyFindsARootWhereNewtonFails) {
  const auto p = make_problem(
      {.cubic = 1.19, .restitution = 0.40, .rate = 2.66, .intensity = 0.22, .mean = -0.264});
  const auto [solution, summary] = solve_closure(p, moment_options(6));
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_GT(summary.half_plane->homotopies, 0);
}

TEST(MomentClosure, ReportsTheOrderAtWhichItIsLost) {
  auto options = moment_options(8);
  options.max_iterations = 1;
  const auto [solution, summary] = solve_closure(paper_case(4), options);
  EXPECT_EQ(solution.status, Status::not_converged);
  EXPECT_NE(solution.reason.find("order 4"), std::string::npos) << solution.reason;
  EXPECT_FALSE(solution.density.has_value());
}

}  // namespace
}  // namespace fpkcheck::epc
