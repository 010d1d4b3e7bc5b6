#include "backward/passage/passage.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "backward/passage/reduced_passage_model.hpp"
#include "backward/passage/renewal_equation.hpp"
#include "backward/passage/stationary_crossings.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::backward {
namespace {

using transform::FirstPassageResult;
using transform::Status;

constexpr double kAmpleSeconds = 300;  // time limit that a busy machine keeps, in seconds

TEST(ChebyshevPlane, ReproducesPolynomialsInTheSquareRootAndInTheVelocity) {
  const ChebyshevGrid grid({-0.5, 1.5, 3}, 4, 5);
  const auto function = [](double y, double v) {
    const double s = std::sqrt(1.5 - y);
    return (1 + s - 2 * s * s * s) * (v + 0.3 * std::pow(v, 4));
  };
  Eigen::MatrixXd values(4, 5);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 5; ++j) values(i, j) = function(grid.y_node(i), grid.v_node(j));
  }
  Eigen::VectorXd y_polynomials(4), v_polynomials(5);
  const auto interpolated = [&](double y, double v) {
    grid.evaluate_y_polynomials(y, y_polynomials);
    grid.evaluate_v_polynomials(v, v_polynomials);
    return y_polynomials.dot(values * v_polynomials);
  };
  EXPECT_NEAR(interpolated(0.7, -2.2), function(0.7, -2.2), 1e-11);
  EXPECT_NEAR(interpolated(grid.y_node(2), 1), function(grid.y_node(2), 1), 1e-11);
  EXPECT_NEAR(interpolated(-2, 4), function(-0.5, 3), 1e-11);  // constant outside
}

TEST(ChebyshevPlane, ReproducesPolynomialsInTheDisplacementWithoutABarrier) {
  const ChebyshevGrid grid({.y_low = -1, .y_high = 2.5, .v_max = 3, .ends_at_barrier = false}, 4,
                           2);
  const auto function = [](double y) { return y * y * y - 2 * y; };
  Eigen::VectorXd values(4), polynomials(4);
  for (int i = 0; i < 4; ++i) values(i) = function(grid.y_node(i));
  const auto interpolated = [&](double y) {
    grid.evaluate_y_polynomials(y, polynomials);
    return polynomials.dot(values);
  };
  EXPECT_NEAR(interpolated(1.7), function(1.7), 1e-11);
  EXPECT_NEAR(interpolated(3), function(2.5), 1e-11);  // constant outside
  EXPECT_NEAR(interpolated(-2), function(-1), 1e-11);
}

// In a Markov chain with three states and the generator L, a basis of three functions makes the
// model exact: S(., t) = exp(L t) 1.
TEST(ReducedPassageModel, IsExactForAChainWithAsManyStatesAsFunctions) {
  const Eigen::Matrix3d generator{{-1.5, 1, 0.2}, {0.4, -2, 1.1}, {0, 0.7, -0.9}};
  const Eigen::Vector3d one = Eigen::Vector3d::Ones();
  const Eigen::Matrix<double, 2, 3> functionals{{1, 0, 0}, {0.2, 0.3, 0.5}};
  const auto transform_at = [&](double shift) -> Eigen::Vector3d {
    return (shift * Eigen::Matrix3d::Identity() - generator).inverse() * one;
  };
  ReducedOrderPassageModel model(3, 2);
  const Eigen::Vector3d mean = transform_at(0), half_mean_square = -generator.inverse() * mean,
                        other = transform_at(0.8);
  model.add_basis_function({mean, functionals * mean});
  model.add_basis_function({half_mean_square, functionals * half_mean_square, 0, 0, true});
  model.add_basis_function({other, functionals * other, 0.8});
  const auto modes = model.compute_modes();
  constexpr double kTime = 1.7;
  // exp(L t) by repeated squaring of the Taylor series of degree 3
  Eigen::Matrix3d survival = generator * kTime / 65536;
  survival = Eigen::Matrix3d::Identity() + survival + survival * survival / 2 +
             survival * survival * survival / 6;
  for (int k = 0; k < 16; ++k) survival = survival * survival;
  const Eigen::Vector2d exact = functionals * survival * one;
  const Eigen::Vector2d computed =
      (modes.coefficients * (kTime * modes.rates).array().exp().matrix()).real();
  EXPECT_NEAR(computed(0), exact(0), 1e-9);
  EXPECT_NEAR(computed(1), exact(1), 1e-9);
}

// With an elastic wall at the equilibrium of a linear force, y is the absolute value of the
// oscillator without a wall, which crosses b and -b equally often.
TEST(StationaryCrossings, ElasticWallGivesTheAbsoluteValueOfTheLinearOscillator) {
  constexpr double kBarrier = 0.5;
  const auto compute = [&](const problem::WallParameters& walls, double y_low, int y_node_count) {
    const problem::Problem problem = tests::with_impulses(
        problem::System({.damping = 0.2, .stiffness = 1}, walls), tests::gaussian_impulses(1, 0.1));
    const ChebyshevGrid grid({.y_low = y_low, .y_high = 2.6, .v_max = 3, .ends_at_barrier = false},
                             y_node_count, 22);
    return *compute_stationary_crossings(problem, grid, kBarrier, 0.5,
                                         base::Deadline::without_time_limit());
  };
  const StationaryCrossings with_wall = compute({.left = 0, .left_restitution = 1}, 0, 18),
                            without = compute({.none = true}, -2.6, 36);
  EXPECT_NEAR(with_wall.rates.sum(), 2 * without.rates.sum(), 1e-4 * with_wall.rates.sum());
  EXPECT_NEAR(with_wall.probability_below, 2 * without.probability_below - 1, 1e-4);
  // In the stationary process upcrossings and downcrossings alternate.
  EXPECT_NEAR(with_wall.upcrossing_rate, with_wall.rates.sum(), 1e-4 * with_wall.rates.sum());
}

// Without a passage before the time limit the integral of exp(-lambda t) is 1 / lambda, from every
// state, and that of t exp(-lambda t) is 1 / lambda^2. A uniform law tests the parts of the panels
// between the jumps of its density.
TEST(RenewalEquation, IntegratesTheTimeToTheNextImpulse) {
  for (const char* law : {"gaussian", "uniform", "laplace"}) {
    const problem::Problem problem = tests::with_impulses(
        problem::System({.damping = 0.3, .stiffness = 1}, {.left = 0, .left_restitution = 0.9}),
        problem::ImpulseTrain({.arrival_rate = 4, .law = law, .intensity = 0.1, .mean = 0}));
    const ChebyshevGrid grid({0, 5, 1}, 5, 7);
    const RenewalEquation equation(problem, grid, 4, 1);
    const auto operators =
        equation.compute_operators({{4}, {4, 1}}, base::Deadline::without_time_limit());
    ASSERT_EQ(operators.size(), 2u);
    const Eigen::Index wall =
        grid.node_index(grid.y_node_count() - 1, 3);  // the node nearest to the wall
    EXPECT_NEAR(operators[0].values_of_one(wall), 0.25, 1e-8) << law;
    EXPECT_NEAR(operators[1].values_of_one(wall), 1.0 / 16, 1e-8) << law;
    EXPECT_NEAR(operators[0].matrix.row(wall).sum(), 0.25, 1e-8) << law;
  }
}

// Values of an independent collocation along characteristics, with about seven digits
TEST(PassageByCharacteristics, HasTheValuesOfAnIndependentComputationInCase1) {
  const FirstPassageResult passage =
      solve_passage(tests::paper_case(1), {.accuracy = 1e-4, .max_seconds = kAmpleSeconds}, 1.5);
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_NEAR(passage.hazard->value, 0.00945683, 6e-9);
  EXPECT_NEAR(passage.mean_from_point->value, 114.2740, 1e-4);
  EXPECT_LT(passage.hazard->error, 1e-5 * passage.hazard->value);
  EXPECT_LT(passage.mean_from_point->error, 1e-5 * passage.mean_from_point->value);
  ASSERT_TRUE(passage.mean_from_stationary);
  EXPECT_NEAR(passage.mean_from_stationary->value, 102.1617, 1e-3);
  EXPECT_NEAR(passage.rice_rate->value, 0.0211775, 1e-6);
  EXPECT_LT(passage.rice_rate->error, 1e-4 * passage.rice_rate->value);
  // P(tau > t) ~ C exp(-g t) with the independent value of C
  ASSERT_EQ(passage.times.size(), 10u);
  ASSERT_EQ(passage.survival_from_stationary.size(), 10u);
  const auto& survival = passage.survival_from_stationary.back();
  EXPECT_NEAR(survival.value, 0.96522 * std::exp(-0.00945683 * passage.times.back()), 3e-6);
  EXPECT_LT(survival.error, 1e-5);
}

TEST(PassageByCharacteristics, StatesAnErrorThatContainsTheChangeToAFinerPlane) {
  const problem::Problem problem =
      tests::make_problem({.damping = 0.3, .restitution = 0.8, .intensity = 0.4});
  const auto solve = [&](double accuracy) {
    return solve_passage(problem, {.accuracy = accuracy, .max_seconds = kAmpleSeconds}, 1, {},
                         transform::PassageStartState{0.3, -0.7});
  };
  const FirstPassageResult coarse = solve(1), fine = solve(1e-4);
  ASSERT_EQ(fine.status, Status::ok) << fine.reason;
  EXPECT_LE(std::abs(coarse.hazard->value - fine.hazard->value), coarse.hazard->error);
  EXPECT_LE(std::abs(coarse.mean_from_point->value - fine.mean_from_point->value),
            coarse.mean_from_point->error);
  EXPECT_GT(coarse.hazard->error, 10 * fine.hazard->error);
}

// In units in which lengths are multiplied by a and times divided by s the mean time is divided by
// s. The test does not need a reference value.
TEST(PassageByCharacteristics, ObeysTheChangeOfUnits) {
  constexpr double a = 1.3, s = 0.7;
  const auto mean = [](double length, double rate) {
    const double per_square = 1 / (length * length);
    const problem::Problem problem =
        tests::with_impulses(problem::System({.damping = 0.3 * rate,
                                              .stiffness = rate * rate,
                                              .cubic = 0.5 * rate * rate * per_square},
                                             {.left = 0, .left_restitution = 0.7}),
                             tests::gaussian_impulses(rate, 0.4 * std::pow(rate, 3) / per_square));
    const FirstPassageResult passage =
        solve_passage(problem, {.accuracy = 1e-3, .max_seconds = kAmpleSeconds}, length);
    EXPECT_EQ(passage.status, Status::ok) << passage.reason;
    return passage.mean_from_point ? passage.mean_from_point->value : 0;
  };
  const double original = mean(1, 1);
  EXPECT_NEAR(mean(a, s) * s, original, 1e-6 * original);
}

// A wrong transformation of the barrier or of the start at rest to wall coordinates would change
// the mean time.
TEST(PassageByCharacteristics, DependsOnTheDistanceFromTheWall) {
  const auto solve = [](double wall) {
    // The force k (y - wall)
    return solve_passage(
        tests::with_impulses(problem::System({.damping = 0.3, .constant = -wall, .stiffness = 1},
                                             {.left = wall, .left_restitution = 0.9}),
                             tests::gaussian_impulses(1, 0.3)),
        {}, wall + 1);
  };
  const FirstPassageResult at_zero = solve(0), shifted = solve(-0.4);
  ASSERT_EQ(at_zero.status, Status::ok) << at_zero.reason;
  EXPECT_NEAR(shifted.mean_from_point->value, at_zero.mean_from_point->value,
              1e-9 * at_zero.mean_from_point->value);
}

// A motion that starts on the wall towards the wall rebounds at once.
TEST(PassageByCharacteristics, ReboundsAtTheStart) {
  const problem::Problem problem =
      tests::make_problem({.damping = 0.3, .restitution = 0.5, .intensity = 0.4});
  const auto mean = [&](double v) {
    const FirstPassageResult passage =
        solve_passage(problem, {}, 1, {}, transform::PassageStartState{0, v});
    EXPECT_EQ(passage.status, Status::ok) << passage.reason;
    return passage.mean_from_point ? passage.mean_from_point->value : 0;
  };
  const double towards_the_wall = mean(-1.2);
  EXPECT_NEAR(towards_the_wall, mean(0.6), 1e-3 * towards_the_wall);
  EXPECT_GT(towards_the_wall, 1.1 * mean(1.2));
}

TEST(PassageByCharacteristics, IsNotOfferedWhereTheMotionIsNotDeterministicOrTheMeansNotSmooth) {
  const problem::System system({.damping = 0.1, .stiffness = 1},
                               {.left = 0, .left_restitution = 1});
  const auto two_point = tests::with_impulses(
      system,
      problem::ImpulseTrain({.arrival_rate = 1, .law = "two_point", .intensity = 0.1, .mean = 0}));
  for (const problem::Problem& problem : {tests::with_noise(system, 0.2), two_point}) {
    const FirstPassageResult passage = solve_passage(problem, {}, 1);
    EXPECT_EQ(passage.status, Status::not_offered);
    EXPECT_FALSE(passage.reason.empty());
  }
}

TEST(PassageByCharacteristics, StatesWhyItFailsWithoutTime) {
  const FirstPassageResult passage =
      solve_passage(tests::paper_case(1), {.max_seconds = 1e-3}, 1.5);
  EXPECT_EQ(passage.status, Status::failed);
  EXPECT_NE(passage.reason.find("time limit"), std::string::npos) << passage.reason;
}

// The motion to a distant barrier has large accelerations, and the grid would have many nodes.
TEST(PassageByCharacteristics, ObeysTheTimeLimitForADistantBarrier) {
  const FirstPassageResult passage = solve_passage(tests::paper_case(1), {.max_seconds = 5}, 1e4);
  EXPECT_EQ(passage.status, Status::failed);
  EXPECT_LT(passage.seconds, 5);
}

// At t = 0.5 the reduced model is inaccurate. Automatic times of another method do not lower the
// status, but requested times do. With the right wall the method computes no stationary law.
TEST(PassageByCharacteristics, OmitsInaccurateTimesThatWereNotRequested) {
  const problem::Problem problem = tests::with_impulses(
      problem::System({.damping = 0.3, .stiffness = 1},
                      {.left = 0, .left_restitution = 0.8, .right = 4, .right_restitution = 0.8}),
      tests::gaussian_impulses(1, 0.4));
  const std::vector<double> times{0.5, 20};
  PassageCollocationOptions options{.accuracy = 1e-3, .max_seconds = kAmpleSeconds};
  EXPECT_EQ(solve_passage(problem, options, 1, times).status, Status::inaccurate);
  options.omits_inaccurate_times = true;
  const FirstPassageResult passage = solve_passage(problem, options, 1, times);
  EXPECT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_EQ(passage.times, std::vector<double>{20});
}

}  // namespace
}  // namespace fpkcheck::backward
