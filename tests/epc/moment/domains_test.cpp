#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <variant>
#include <vector>

#include "closures.hpp"
#include "epc/solve.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "paper_cases.hpp"
#include "transform/coordinate_transformation.hpp"

// Tests of the formulation moment for oscillators other than the paper's: with walls at any
// position or no wall, with several wells, with ring-shaped densities, and under noise.
namespace fpkcheck::epc {
namespace {

using problem::System;
using tests::gaussian_impulses;
using tests::in_wall_coordinates;
using tests::with_impulses;
using tests::with_noise;
using transform::SmoothDensity;
using transform::Status;

ClosureResult solve_moment(const problem::Problem& problem, int order) {
  return solve_closure(in_wall_coordinates(problem),
                       tests::closure_options(Formulation::moment, order));
}

SmoothDensity physical_density_of(const problem::Problem& problem, const ClosureResult& result) {
  return std::get<SmoothDensity>(transform::to_physical_coordinates(
      problem::wall_frame(problem.system), *result.solution.density));
}

struct Distance {
  double y = 0, v = 0;
};
// L1 distances of p(y) and p(v) over the box of the first density.
Distance l1_distances(const SmoothDensity& p, const std::function<double(double, double)>& q) {
  constexpr int kPanels = 16;
  const auto ys = numerics::composite_gauss_points(p.y_min, p.y_max, kPanels);
  const auto vs = numerics::composite_gauss_points(-p.v_max, p.v_max, kPanels);
  std::vector<double> of_v(vs.size());
  Distance sum;
  for (const auto& y : ys) {
    double row = 0;
    for (std::size_t j = 0; j < vs.size(); ++j) {
      const double difference = p.value(y.at, vs[j].at) - q(y.at, vs[j].at);
      row += vs[j].weight * difference;
      of_v[j] += y.weight * difference;
    }
    sum.y += y.weight * std::abs(row);
  }
  for (std::size_t j = 0; j < vs.size(); ++j) sum.v += vs[j].weight * std::abs(of_v[j]);
  return sum;
}

const System kDoubleWell({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true});
System van_der_pol_system(double epsilon) {
  return System({.damping = -epsilon, .van_der_pol = epsilon, .stiffness = 1}, {.none = true});
}

// The moment equations of a linear oscillator without a wall are closed: n = 4 gives all moments up
// to degree 4 exactly, for every law, with a mean of the impulses and additional noise.
TEST(MomentClosureWithoutWall, GivesAllMomentsOfTheLinearProcess) {
  const System linear({.damping = 0.2, .stiffness = 1.3}, {.none = true});
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform", "exponential", "gamma"}) {
    problem::Problem p = with_impulses(
        linear,
        problem::ImpulseTrain({.arrival_rate = 1.5, .law = law, .intensity = 0.2, .mean = 0.08}));
    p.noise = {0.15};
    for (const int order : {4, 6}) {
      const auto result = solve_moment(p, order);
      ASSERT_EQ(result.solution.status, Status::ok) << law << ": " << result.solution.reason;
      const auto& moments = result.solution.moments;
      const auto fourth = [&](int a, int b) {  // E[y^4] or E[v^4]
        const auto k = [&](int n) { return exact::linear_cumulant(p, n * a, n * b); };
        return k(4) + 4 * k(3) * k(1) + 3 * k(2) * k(2) + 6 * k(2) * k(1) * k(1) +
               std::pow(k(1), 4);
      };
      const double y1 = exact::linear_cumulant(p, 1, 0), y2 = exact::linear_cumulant(p, 2, 0);
      EXPECT_NEAR(moments.y1 / y1, 1, 1e-8) << law << order;
      EXPECT_NEAR(moments.y2 / (y2 + y1 * y1), 1, 1e-8) << law << order;
      EXPECT_NEAR(moments.y4 / fourth(1, 0), 1, 1e-8) << law << order;
      EXPECT_NEAR(moments.v1, 0, 1e-9) << law << order;
      EXPECT_NEAR(moments.v2 / exact::linear_cumulant(p, 0, 2), 1, 1e-8) << law << order;
      EXPECT_NEAR(moments.v4 / fourth(0, 1), 1, 1e-8) << law << order;
      // A mixed moment.
      const auto& density = std::get<SmoothDensity>(*result.solution.density);
      const double y2v = transform::expectation(
          density, [y1](double y, double v) { return (y - y1) * (y - y1) * v; });
      EXPECT_NEAR(y2v, exact::linear_cumulant(p, 2, 1), 1e-8) << law << order;
    }
  }
}

// Problems whose exact density has an exponent of degree 4 or 6: the closure is exact.
struct ExactCase {
  const char* name;
  System system;
  double intensity;
  int order;
};
std::vector<ExactCase> exact_cases() {
  return {
      {"double well", System({.damping = 0.2, .stiffness = -1, .cubic = 1}, {.none = true}), 0.1,
       4},
      {"three wells",
       System({.damping = 0.2, .stiffness = 1, .cubic = -2, .quintic = 1}, {.none = true}), 0.05,
       6},
      {"ring",
       System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}),
       0.4, 4},
      {"gap",
       System({.damping = 0.2, .stiffness = 1, .cubic = 0.3},
              {.left = -0.5, .left_restitution = 1}),
       0.4, 4},
      {"pressed to its wall",
       System({.damping = 0.2, .stiffness = 1, .quadratic = 0.4, .cubic = 0.3},
              {.left = 0.5, .left_restitution = 1}),
       0.4, 4},
      {"wall on the right",
       System({.damping = 0.2, .constant = 0.1, .stiffness = 1, .quadratic = 0.3, .cubic = 0.4},
              {.right = 0.7, .right_restitution = 1}),
       0.3, 4},
      {"wells between walls",
       System({.damping = 0.2, .stiffness = -1, .cubic = 1},
              {.left = -1.5, .left_restitution = 1, .right = 1.2, .right_restitution = 1}),
       0.1, 4},
      {"ball", System({.damping = 0.2, .constant = 1, .restitution = 1}), 0.4, 4},
      {"box",
       System({.damping = 0.2},
              {.left = 1, .left_restitution = 1, .right = 2, .right_restitution = 1}),
       0.4, 4},
  };
}

TEST(MomentClosureOnDomains, IsExactWhereTheExponentIsAPolynomial) {
  for (const auto& [name, system, intensity, order] : exact_cases()) {
    const auto p = with_noise(system, intensity);
    const exact::EnergyLaw law(p);
    const auto result = solve_moment(p, order);
    ASSERT_EQ(result.solution.status, Status::ok) << name << ": " << result.solution.reason;
    const SmoothDensity density = physical_density_of(p, result);
    const auto [y, v] = l1_distances(density, law);
    EXPECT_LT(y, 1e-7) << name;
    EXPECT_LT(v, 1e-7) << name;
    // Moments are in physical coordinates for every frame.
    const auto& moments = result.solution.moments;
    EXPECT_NEAR(moments.y1, law.moment(1, 0), 1e-7) << name;
    EXPECT_NEAR(moments.y2, law.moment(2, 0), 1e-7) << name;
    EXPECT_NEAR(moments.y4, law.moment(4, 0), 1e-6) << name;
    EXPECT_NEAR(moments.v2, law.moment(0, 2), 1e-7) << name;
    EXPECT_NEAR(moments.v4, law.moment(0, 4), 1e-6) << name;
  }
}

// The balances are moment equations of degree 2, which orders n >= 2 satisfy exactly. Their terms
// are computed from the density independently.
TEST(MomentClosureOnDomains, KeepsTheBalancesWithLossesAtEveryWall) {
  const problem::WallParameters both{
      .left = -0.5, .left_restitution = 0.7, .right = 1, .right_restitution = 0.9};
  auto mixed = with_impulses(System({.damping = 0.1,
                                     .van_der_pol = 0.2,
                                     .rayleigh = 0.1,
                                     .constant = 0.1,
                                     .stiffness = 1,
                                     .quadratic = 0.2},
                                    both),
                             gaussian_impulses(2, 0.2, 0.05));
  mixed.noise = {0.1};
  const std::vector<problem::Problem> problems{
      with_impulses(System({.damping = 0.1, .stiffness = 1}, both), gaussian_impulses(2, 0.2)),
      mixed,
      with_impulses(
          System({.damping = 0.1, .stiffness = 1}, {.right = 0.4, .right_restitution = 0.8}),
          gaussian_impulses(1, 0.1, -0.03)),
      with_noise(System({.damping = 0.1, .stiffness = 1, .restitution = 0.8}), 0.1)};
  for (const auto& p : problems) {
    const auto [solution, summary] = solve_moment(p, 4);
    ASSERT_EQ(solution.status, Status::ok)
        << non_default_parameters_text(p) << ": " << solution.reason;
    EXPECT_LT(std::abs(solution.energy_residual), 1e-7) << non_default_parameters_text(p);
    EXPECT_LT(std::abs(*summary.balances.virial), 1e-7) << non_default_parameters_text(p);
    EXPECT_LT(std::abs(*summary.balances.momentum), 1e-7) << non_default_parameters_text(p);
    EXPECT_NEAR(solution.mass, 1, 1e-9) << non_default_parameters_text(p);
  }
}

// In a symmetric well without a wall both sides of the balance of momentum are 0.
TEST(MomentClosureOnDomains, HasNoBalanceOfMomentumWhereNothingIsHit) {
  EXPECT_FALSE(solve_moment(with_noise(van_der_pol_system(0.2), 0.2), 4).summary.balances.momentum);
}

// For the mirror image of the paper's case 1 another search path leads to the same root.
TEST(MomentClosureOnDomains, AMirrorImageReflectsTheSolution) {
  const auto original = tests::make_problem({.mean = 0.03});
  const auto mirrored = with_impulses(System({.damping = 0.1, .stiffness = 1, .cubic = 0.1},
                                             {.right = 0, .right_restitution = 0.98}),
                                      gaussian_impulses(1, 0.1, -0.03));
  const auto here =
      solve_closure(original, tests::closure_options(Formulation::moment, 6)).solution;
  const auto there = solve_moment(mirrored, 6).solution;
  ASSERT_EQ(there.status, Status::ok) << there.reason;
  EXPECT_NEAR(there.moments.y1, -here.moments.y1, 1e-8);
  EXPECT_NEAR(there.moments.y2, here.moments.y2, 1e-8);
  EXPECT_NEAR(there.moments.y4, here.moments.y4, 1e-8);
  EXPECT_NEAR(there.moments.v4, here.moments.v4, 1e-8);
}

// If both walls are exchanged with their restitution coefficients, y changes its sign.
TEST(MomentClosureOnDomains, ExchangedWallsReflectTheSolution) {
  const auto between = [](double left, double r_left, double right, double r_right, double mean) {
    const System system(
        {.damping = 0.1, .stiffness = 1},
        {.left = left, .left_restitution = r_left, .right = right, .right_restitution = r_right});
    return solve_moment(with_impulses(system, gaussian_impulses(2, 0.2, mean)), 4).solution;
  };
  const auto here = between(-0.5, 0.7, 1, 0.9, 0.05), there = between(-1, 0.9, 0.5, 0.7, -0.05);
  EXPECT_GT(std::abs(here.moments.y1), 0.1);
  EXPECT_NEAR(there.moments.y1, -here.moments.y1, 1e-8);
  EXPECT_NEAR(there.moments.y2, here.moments.y2, 1e-8);
  EXPECT_NEAR(there.moments.v2, here.moments.v2, 1e-8);
}

// A simulation gives E[y^2] = .83849 +- .0002 and E[v^4] = .2041 +- .0004. The tolerance includes
// the error of the closure.
TEST(MomentClosureOnDomains, IsNearTheSimulationAtOrderEight) {
  const auto well =
      solve_moment(with_impulses(kDoubleWell, gaussian_impulses(1, 0.05)), 8).solution;
  ASSERT_EQ(well.status, Status::ok) << well.reason;
  EXPECT_NEAR(well.moments.y2, 0.8384904, 4 * 0.0002 + 2e-4);
  EXPECT_NEAR(well.moments.v4, 0.204132, 4 * 0.0004);
  EXPECT_NEAR(well.moments.v2, 0.25, 1e-8);  // lambda E[Y^2] / (2c) for every spring
}

// The L1 distance to order n + 2 approximates the error at order n.
TEST(MomentClosureOnDomains, ConvergesInTheOrder) {
  const System gap({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 0.98});
  const struct {
    problem::Problem problem;
    double y, v;
  } cases[] = {{with_impulses(gap, gaussian_impulses(1, 0.1)), 5e-3, 5e-3},
               {with_noise(van_der_pol_system(0.2), 0.2), 5e-3, 5e-3},
               {with_impulses(kDoubleWell, gaussian_impulses(1, 0.05)), 1e-2, 5e-3}};
  for (const auto& [problem, bar_y, bar_v] : cases) {
    std::vector<Distance> to_next;
    for (const int order : {4, 8}) {
      const auto coarse = solve_moment(problem, order), fine = solve_moment(problem, order + 2);
      ASSERT_EQ(coarse.solution.status, Status::ok) << coarse.solution.reason;
      ASSERT_EQ(fine.solution.status, Status::ok) << fine.solution.reason;
      to_next.push_back(l1_distances(std::get<SmoothDensity>(*fine.solution.density),
                                     std::get<SmoothDensity>(*coarse.solution.density).value));
    }
    EXPECT_LT(to_next[1].y, bar_y) << non_default_parameters_text(problem);
    EXPECT_LT(to_next[1].v, bar_v) << non_default_parameters_text(problem);
    EXPECT_LT(to_next[1].y, to_next[0].y / 2) << non_default_parameters_text(problem);
    EXPECT_LT(to_next[1].v, to_next[0].v / 2) << non_default_parameters_text(problem);
  }
}

// The marginal densities of both orders are on the same panels, although the supports differ.
TEST(MomentClosureOnDomains, StatesTheDistanceToTheOrderBefore) {
  const auto p = with_impulses(kDoubleWell, gaussian_impulses(1, 0.05));
  const auto before = solve_moment(p, 4), here = solve_moment(p, 6);
  const auto [y, v] = l1_distances(std::get<SmoothDensity>(*here.solution.density),
                                   std::get<SmoothDensity>(*before.solution.density).value);
  ASSERT_TRUE(here.summary.distance_to_previous);
  EXPECT_NEAR(*here.summary.distance_to_previous / (y + v), 1, 0.05);
}

// For epsilon = 1, order 2 gives no ring-shaped density: the density decays by the confinement
// alone.
TEST(MomentClosureOnDomains, IsInadmissibleIfTheConfinementAloneMakesItDecay) {
  const auto [solution, summary] = solve_moment(with_noise(van_der_pol_system(1), 0.2), 2);
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_NE(solution.reason.find("at the confinement level"), std::string::npos) << solution.reason;
}

}  // namespace
}  // namespace fpkcheck::epc
