#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "fd_fpk/applicability.hpp"
#include "fd_fpk/solve.hpp"
#include "general_oscillators.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::Problem;
using problem::System;
using problem::WallParameters;
using transform::StateVariable;
using transform::Status;

FiniteVolumeOptions quick(DensityEquation equation = DensityEquation::kf) {
  return {.equation = equation, .stepper = StationarySolver::direct, .error_estimate = false};
}

transform::Solution solve_in_frame(const Problem& p, const FiniteVolumeOptions& options) {
  const Problem seen = tests::in_wall_coordinates(p);
  EXPECT_EQ(unsupported_reason(seen, options), "");
  return transform::to_physical_coordinates(seen.frame,
                                            solve_stationary_density(seen, options).solution);
}

// Larger L1 distance of the two marginals from an exact law, on the cells of the solution.
template <class Law>
double marginal_error(const transform::Solution& solution, const Law& law) {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const auto& grid = std::get<transform::GridDensity>(*solution.density);
  const auto l1 = [&](StateVariable variable, const std::vector<double>& edges, const auto& exact) {
    const auto m = marginal(solution, variable, edges);
    double sum = 0;
    for (std::size_t b = 0; b < m.size(); ++b) {
      sum +=
          std::abs(m.density[b] * m.bin_width(b) - Rule::integrate(exact, edges[b], edges[b + 1]));
    }
    return sum;
  };
  return std::max(
      l1(StateVariable::y, grid.y_edges, [&](double y) { return law.displacement_marginal(y); }),
      l1(StateVariable::ydot, grid.v_edges, [&](double v) { return law.velocity_marginal(v); }));
}

struct ExactCase {
  std::string name;
  System system;
  double intensity;
  double bar;
};

std::vector<ExactCase> exact_cases() {
  const problem::SystemCoefficients linear{.damping = 0.2, .stiffness = 1};
  const auto left = [](double at) { return WallParameters{.left = at, .left_restitution = 1}; };
  return {
      {"no wall", System(linear, {.none = true}), 0.4, 2e-5},
      {"a wall at -0.5", System(linear, left(-0.5)), 0.4, 2e-5},
      {"a wall at 0.5", System(linear, left(0.5)), 0.4, 2e-5},
      {"a wall on the right", System(linear, WallParameters{.right = 0.5, .right_restitution = 1}),
       0.4, 2e-5},
      {"two walls",
       System(linear, {.left = -0.5, .left_restitution = 1, .right = 1, .right_restitution = 1}),
       0.4, 2e-5},
      {"a bouncing ball", System({.damping = 0.2, .constant = 1}, left(0)), 0.4, 2e-5},
      {"two wells", System({.damping = 0.2, .stiffness = -1, .cubic = 1}, {.none = true}), 0.1,
       1e-4},
      {"a ring",
       System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}),
       0.4, 1e-4}};
}

TEST(SolveGeneralOscillator, MeetsTheExactLawsOfTheEnergyOnItsAutomaticGrids) {
  for (const auto& [name, system, intensity, bar] : exact_cases()) {
    const Problem p = tests::with_noise(system, intensity);
    const auto solution = solve_in_frame(p, quick());
    ASSERT_EQ(solution.status, Status::ok) << name << ": " << solution.reason;
    EXPECT_NEAR(solution.mass, 1, 1e-10) << name;
    const exact::EnergyLaw law(p);
    EXPECT_LT(marginal_error(solution, law), bar) << name;
    // Moments are physical, although the solver uses wall coordinates.
    const double sizes[] = {std::sqrt(law.moment(2, 0)), law.moment(2, 0), law.moment(4, 0)};
    EXPECT_NEAR(solution.moments.y1, law.moment(1, 0), 2e-4 * sizes[0]) << name;
    EXPECT_NEAR(solution.moments.y2, law.moment(2, 0), 2e-4 * sizes[1]) << name;
    EXPECT_NEAR(solution.moments.y4, law.moment(4, 0), 3e-4 * sizes[2]) << name;
    EXPECT_NEAR(solution.moments.v2, law.moment(0, 2), 1e-4 * law.moment(0, 2)) << name;
    EXPECT_NEAR(solution.moments.v4, law.moment(0, 4), 2e-4 * law.moment(0, 4)) << name;
  }
}

// Options of the identical equation, or empty
std::optional<FiniteVolumeOptions> identical(const Problem& problem, DensityEquation equation,
                                             ImpactCondition impact = ImpactCondition::map) {
  FiniteVolumeOptions options = quick(equation);
  options.impact = impact;
  return options_of_identical_equation(tests::in_wall_coordinates(problem), options);
}

TEST(SolveGeneralOscillator, EquationsWithoutImpulsesAreIdentical) {
  const problem::SystemCoefficients linear{.damping = 0.2, .stiffness = 1};
  const auto with_wall = [&](double restitution) {
    return System(linear, WallParameters{.left = -0.5, .left_restitution = restitution});
  };
  for (const double restitution : {0.7, 1.0}) {
    const Problem p = tests::with_noise(with_wall(restitution), 0.4);
    std::vector<double> moments;
    for (const auto equation :
         {DensityEquation::white, DensityEquation::km4, DensityEquation::kf}) {
      EXPECT_EQ(identical(p, equation)->equation, DensityEquation::kf);
      moments.push_back(solve_in_frame(p, quick(equation)).moments.v4);
    }
    EXPECT_NEAR(moments[1], moments[0], 1e-10 * moments[0]) << restitution;
    EXPECT_NEAR(moments[2], moments[0], 1e-10 * moments[0]) << restitution;
  }
  const Problem lossy = tests::with_noise(with_wall(0.7), 0.4);
  const Problem elastic = tests::with_noise(with_wall(1), 0.4);
  EXPECT_EQ(identical(lossy, DensityEquation::km4, ImpactCondition::delta)->impact,
            ImpactCondition::delta);
  EXPECT_EQ(identical(elastic, DensityEquation::km4, ImpactCondition::delta)->impact,
            ImpactCondition::map);
  FiniteVolumeOptions delta = quick(DensityEquation::km4);
  delta.impact = ImpactCondition::delta;
  EXPECT_NEAR(solve_in_frame(elastic, delta).moments.v4,
              solve_in_frame(elastic, quick(DensityEquation::km4)).moments.v4, 1e-10);
  const Problem impulses = tests::with_impulses(with_wall(1), tests::gaussian_impulses(1, 0.4));
  EXPECT_EQ(identical(impulses, DensityEquation::km4)->equation, DensityEquation::km4);
  // The impact condition delta requires one wall.
  const Problem no_wall = tests::with_noise(System(linear, {.none = true}), 0.4);
  EXPECT_FALSE(identical(no_wall, DensityEquation::km4, ImpactCondition::delta));
}

// Order 7 is the automatic choice for a smooth density; an order of the options takes precedence.
TEST(SolveGeneralOscillator, AutomaticOrderIsSevenWithoutLossesAtWalls) {
  const problem::SystemCoefficients linear{.damping = 0.2, .stiffness = 1};
  const auto with_wall = [&](double restitution) {
    return tests::with_noise(
        System(linear, WallParameters{.left = -0.5, .left_restitution = restitution}), 0.4);
  };
  const auto order = [](const Problem& p, FiniteVolumeOptions options = quick()) {
    return solve_stationary_density(tests::in_wall_coordinates(p), options).summary.order;
  };
  EXPECT_EQ(order(tests::with_noise(System(linear, {.none = true}), 0.4)), 7);
  EXPECT_EQ(order(with_wall(1)), 7);
  EXPECT_EQ(order(with_wall(0.8)), 5);
  FiniteVolumeOptions fifth = quick();
  fifth.order = 5;
  EXPECT_EQ(order(with_wall(1), fifth), 5);
  // The paper's oscillator has the order of the published results.
  const System at_wall(linear, WallParameters{.left = 0, .left_restitution = 1});
  EXPECT_EQ(order(tests::with_impulses(at_wall, tests::gaussian_impulses(1, 0.1))), 5);
}

// E[x^4] from the cumulants 1 .. 4.
double fourth_moment(double k1, double k2, double k3, double k4) {
  return k4 + 4 * k3 * k1 + 3 * k2 * k2 + 6 * k2 * k1 * k1 + std::pow(k1, 4);
}

problem::ImpulseTrain skew_impulses(const char* law, double skewness, double mean) {
  return problem::ImpulseTrain(
      {.arrival_rate = 1, .law = law, .intensity = 0.1, .mean = mean, .skewness = skewness});
}

// E[(v - E[v])^3], with v uniform in each cell.
double third_central_moment(const transform::Solution& solution) {
  const auto& grid = std::get<transform::GridDensity>(*solution.density);
  const auto p = marginal(solution, StateVariable::ydot, grid.v_edges);
  double sum = 0;
  for (std::size_t b = 0; b < p.size(); ++b) {
    const double low = grid.v_edges[b] - solution.moments.v1;
    const double high = grid.v_edges[b + 1] - solution.moments.v1;
    sum += p.density[b] * (std::pow(high, 4) - std::pow(low, 4)) / 4;
  }
  return sum;
}

TEST(SolveGeneralOscillator, HasTheExactCumulantsOfTheLinearOscillatorUnderImpulsesAndNoise) {
  for (const auto& impulses :
       {tests::gaussian_impulses(1, 0.1, 0.1), skew_impulses("exponential", 2, 0.1),
        skew_impulses("exponential", -2, 0.1), skew_impulses("gamma", 0.7, 0)}) {
    SCOPED_TRACE(testing::Message()
                 << impulses.amplitude_law().name() << ' ' << impulses.amplitude_law().skewness());
    Problem p =
        tests::with_impulses(System({.damping = 0.2, .stiffness = 1}, {.none = true}), impulses);
    p.noise = {0.1};
    const auto solution = solve_in_frame(p, quick());
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    const auto y = [&](int n) { return exact::linear_cumulant(p, n, 0); };
    const auto v = [&](int n) { return exact::linear_cumulant(p, 0, n); };
    const auto& m = solution.moments;
    // Truncation by the box of a tail exp(-y): 2e-6 of E[v^2], 2e-5 of E[v^4].
    const double tail = impulses.amplitude_law().is_symmetric() ? 1 : 10;
    EXPECT_NEAR(m.y1, y(1), 1e-6);
    EXPECT_NEAR(m.y2, y(2) + y(1) * y(1), 3e-7 * tail * y(2));
    EXPECT_NEAR(m.v1, 0, 1e-6);
    EXPECT_NEAR(m.v2, v(2), 3e-7 * tail * v(2));
    const double y4 = fourth_moment(y(1), y(2), y(3), y(4));
    const double v4 = fourth_moment(v(1), v(2), v(3), v(4));
    EXPECT_NEAR(m.y4, y4, 5e-6 * tail * y4);
    EXPECT_NEAR(m.v4, v4, 5e-6 * tail * v4);
    // The third central moment vanishes for laws symmetric about their mean.
    EXPECT_NEAR(third_central_moment(solution), v(3), 1e-4 * std::pow(v(2), 1.5));
  }
}

// The mirror image of a problem, with skew impulses mirrored too.
TEST(SolveGeneralOscillator, MirroredProblemsHaveMirroredMoments) {
  const problem::SystemCoefficients to_the_right{
      .damping = 0.2, .constant = -0.2, .stiffness = 1, .quadratic = 0.1, .cubic = 0.1};
  const problem::SystemCoefficients to_the_left{
      .damping = 0.2, .constant = 0.2, .stiffness = 1, .quadratic = -0.1, .cubic = 0.1};
  FiniteVolumeOptions options = quick();
  options.refinement = 0.6;
  const auto one = solve_in_frame(
      tests::with_impulses(
          System(to_the_right, WallParameters{.left = -0.3, .left_restitution = 0.9}),
          skew_impulses("exponential", 2, 0.05)),
      options);
  const auto other = solve_in_frame(
      tests::with_impulses(
          System(to_the_left, WallParameters{.right = 0.3, .right_restitution = 0.9}),
          skew_impulses("exponential", -2, -0.05)),
      options);
  ASSERT_TRUE(one.density && other.density);
  EXPECT_NEAR(one.moments.y1, -other.moments.y1, 1e-9);
  EXPECT_NEAR(one.moments.y4, other.moments.y4, 1e-9);
  EXPECT_NEAR(one.moments.v2, other.moments.v2, 1e-9);
  EXPECT_NEAR(one.energy_residual, other.energy_residual, 1e-9);
  EXPECT_GT(std::abs(one.moments.y1), 0.1);
}

TEST(SolveGeneralOscillator, WithoutImpulsesAllEquationsAreTheSame) {
  const Problem p = tests::with_noise(System({.damping = 0.2, .stiffness = 1},
                                             WallParameters{.left = -0.5, .left_restitution = 0.8}),
                                      0.4);
  FiniteVolumeOptions options = quick(DensityEquation::white);
  options.refinement = 0.5;
  const auto white = solve_in_frame(p, options);
  for (const DensityEquation equation :
       {DensityEquation::km4, DensityEquation::km4_pade, DensityEquation::kf}) {
    options.equation = equation;
    const auto other = solve_in_frame(p, options);
    EXPECT_EQ(other.moments.y1, white.moments.y1);
    EXPECT_EQ(other.moments.v4, white.moments.v4);
  }
}

// Frequent small impulses are equivalent to white noise, and add to external white noise.
TEST(SolveGeneralOscillator, FrequentImpulsesAndNoiseAddUp) {
  const System system({.damping = 0.4, .stiffness = 1},
                      WallParameters{.left = -0.5, .left_restitution = 1});
  Problem p = tests::with_impulses(system, tests::gaussian_impulses(400, 0.2));
  p.noise = {0.2};
  const exact::EnergyLaw law(p);
  for (const DensityEquation equation :
       {DensityEquation::white, DensityEquation::km4, DensityEquation::kf}) {
    const auto solution = solve_in_frame(p, quick(equation));
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_LT(marginal_error(solution, law), equation == DensityEquation::white ? 2e-5 : 1e-3);
  }
}

// With losses there is no exact law: the balances must hold for status `ok`, and grids must agree.
TEST(SolveGeneralOscillator, WithLossesKeepsItsBalancesAndAgreesWithFinerGrids) {
  struct Case {
    std::string name;
    Problem problem;
  };
  Problem mixed =
      tests::with_impulses(System({.damping = 0.1, .stiffness = 1},
                                  WallParameters{.left = -0.5, .left_restitution = 0.8}),
                           tests::gaussian_impulses(1, 0.1));
  mixed.noise = {0.1};
  const std::vector<Case> cases{
      {"gap", tests::with_impulses(System({.damping = 0.1, .stiffness = 1},
                                          WallParameters{.left = -0.5, .left_restitution = 0.9}),
                                   tests::gaussian_impulses(1, 0.1))},
      {"two walls",
       tests::with_impulses(
           System({.damping = 0.1, .stiffness = 1},
                  {.left = -0.5, .left_restitution = 0.7, .right = 1, .right_restitution = 0.9}),
           tests::gaussian_impulses(2, 0.2))},
      {"mixed", mixed},
      {"ring", tests::with_impulses(
                   System({.damping = -0.2, .van_der_pol = 0.2, .stiffness = 1}, {.none = true}),
                   tests::gaussian_impulses(2, 0.2))}};
  for (const auto& [name, p] : cases) {
    FiniteVolumeOptions options = quick();
    options.refinement = 0.7;
    const Problem seen = tests::in_wall_coordinates(p);
    const auto coarse = solve_stationary_density(seen, options);
    options.refinement = 1;
    const auto fine = solve_stationary_density(seen, options);
    ASSERT_EQ(fine.solution.status, Status::ok) << name << ": " << fine.solution.reason;
    EXPECT_LT(std::abs(fine.solution.energy_residual), 1e-4) << name;
    EXPECT_LT(std::abs(fine.summary.balances.virial.value()), 1e-4) << name;
    EXPECT_LT(std::abs(fine.summary.balances.momentum.value_or(0)), 1e-4) << name;
    EXPECT_NEAR(coarse.solution.moments.y2, fine.solution.moments.y2,
                2e-3 * fine.solution.moments.y2)
        << name;
    EXPECT_NEAR(coarse.solution.moments.v2, fine.solution.moments.v2,
                1e-3 * fine.solution.moments.v2)
        << name;
  }
}

// The error of the first-order impact is of second order in 1-r.
TEST(SolveGeneralOscillator, ErrorOfTheFirstOrderImpactIsQuadraticInTheLoss) {
  const auto off = [](double loss) {
    const Problem p =
        tests::with_impulses(System({.damping = 0.2, .stiffness = 1},
                                    WallParameters{.left = -0.3, .left_restitution = 1 - loss}),
                             tests::gaussian_impulses(2, 0.4));
    FiniteVolumeOptions map = quick(), delta = quick();
    map.origin_refinement = delta.origin_refinement = 4;
    delta.impact = ImpactCondition::delta;
    const auto exact = solve_in_frame(p, map), first_order = solve_in_frame(p, delta);
    EXPECT_TRUE(first_order.has_status_ok()) << first_order.reason;
    return first_order.moments.v2 - exact.moments.v2;
  };
  const double small = off(0.02), large = off(0.04);
  EXPECT_LT(small, 0);  // kappa = 1-r dissipates more energy than (1-r^2)/2
  EXPECT_GT(large / small, 3.4);
  EXPECT_LT(large / small, 4.4);
}

TEST(FdApplicability, RefusesUnsupportedProblems) {
  const auto wall = [](double r) { return WallParameters{.left = -0.5, .left_restitution = r}; };
  const problem::SystemCoefficients linear{.damping = 0.2, .stiffness = 1};
  const FiniteVolumeOptions kf, white{.equation = DensityEquation::white},
      delta{.equation = DensityEquation::km4, .impact = ImpactCondition::delta},
      along{.transport = TransportScheme::characteristics};
  const Problem noisy = tests::with_noise(System(linear, wall(0.16)), 0.4);
  EXPECT_NE(unsupported_reason(tests::in_wall_coordinates(noisy), kf), "");
  EXPECT_EQ(unsupported_reason(
                tests::in_wall_coordinates(tests::with_noise(System(linear, wall(0.17)), 0.4)), kf),
            "");
  const Problem kicked =
      tests::with_impulses(System(linear, wall(0.16)), tests::gaussian_impulses(1, 0.1));
  EXPECT_EQ(unsupported_reason(tests::in_wall_coordinates(kicked), kf), "");
  EXPECT_NE(unsupported_reason(tests::in_wall_coordinates(kicked), white), "");
  const Problem gap =
      tests::with_impulses(System(linear, wall(0.9)), tests::gaussian_impulses(1, 0.1));
  EXPECT_EQ(unsupported_reason(tests::in_wall_coordinates(gap), kf), "");
  EXPECT_EQ(unsupported_reason(tests::in_wall_coordinates(gap), delta), "");
  const Problem without_wall = tests::with_impulses(System(linear, {.none = true}), gap.impulses);
  EXPECT_NE(unsupported_reason(tests::in_wall_coordinates(without_wall), delta), "");
  EXPECT_EQ(unsupported_reason(tests::in_wall_coordinates(gap), along), "");
  EXPECT_NE(unsupported_reason(tests::in_wall_coordinates(noisy), along), "");
  // With a force towards the wall the law has an atom, which only kf along characteristics treats.
  const Problem pressed = tests::with_impulses(
      System({.damping = 0.2, .constant = 1}, WallParameters{.left = 0, .left_restitution = 0.7}),
      tests::gaussian_impulses(1, 0.5));
  EXPECT_EQ(unsupported_reason(tests::in_wall_coordinates(pressed), kf), "");
  EXPECT_NE(unsupported_reason(tests::in_wall_coordinates(pressed), delta), "");
  EXPECT_NE(unsupported_reason(tests::in_wall_coordinates(pressed),
                               {.equation = DensityEquation::km4_pade}),
            "");
  EXPECT_EQ(unsupported_reason(tests::in_wall_coordinates(pressed), white), "");
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
