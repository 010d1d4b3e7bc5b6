#include "fd_fpk/functionals/passage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

#include "exact/random_acceleration.hpp"
#include "fd_fpk/functionals/barrier_passage.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::FirstPassageResult;
using transform::Status;
using transform::ValueWithError;

void expect_value(const std::optional<ValueWithError>& found, double exact, const char* what) {
  ASSERT_TRUE(found) << what;
  EXPECT_NEAR(found->value, exact, 1e-3 * exact) << what;
  EXPECT_LE(std::abs(found->value - exact), found->error) << what;
}

// Values of an independent collocation along characteristics, with about seven digits
TEST(Passage, HasTheValuesOfAnIndependentMethodInCase1) {
  const FirstPassageResult passage =
      solve_passage(tests::paper_case(1), {}, {.level = 1.5}, {10, 100});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  expect_value(passage.hazard, 0.00945683, "hazard");
  expect_value(passage.mean_from_point, 114.2740, "mean from rest");
  expect_value(passage.mean_from_stationary, 102.1617, "mean from stationary");
  expect_value(passage.rice_rate, 0.0211775, "Rice's rate");
  // S(t) ~ C exp(-g t) with C = 0.96522
  EXPECT_NEAR(passage.survival_from_stationary[1].value, 0.96522 * std::exp(-0.945683), 1e-3);
  EXPECT_LT(passage.survival_from_stationary[0].value, 1);
  EXPECT_GT(passage.survival_from_point[0].value, passage.survival_from_stationary[0].value);
}

// The hazard is smaller than the rate of upcrossings nu / P, since passages come in clumps, and the
// mean from the stationary law is the integral of the survival probability.
TEST(Passage, HasASmallerHazardThanTheRateOfUpcrossings) {
  const auto p = tests::make_problem({.damping = 0.3, .intensity = 0.3});
  std::vector<double> times;
  constexpr double kStep = 0.25;
  constexpr int kIntervals = 240;
  for (int k = 0; k <= kIntervals; ++k) times.push_back(kStep * k);
  const FirstPassageResult passage = solve_passage(p, {.accuracy = 0.1}, {.level = 1}, times);
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  const double hazard = passage.hazard->value;
  EXPECT_LT(hazard, passage.rice_rate->value / passage.probability_below->value);
  const auto& survival = passage.survival_from_stationary;
  double integral = survival.back().value / hazard;  // of the tail, C exp(-g t)
  for (int k = 0; k < kIntervals; ++k) {
    integral += kStep * (survival[k].value + survival[k + 1].value) / 2;
  }
  EXPECT_NEAR(integral, passage.mean_from_stationary->value, 1e-2 * integral);
}

// x'' = xi of intensity 2D = 1 with a wall at 0. The motion beyond the barrier at 1, up to a second
// wall, has no effect on passages from a point.
problem::Problem random_acceleration(double restitution) {
  return tests::with_noise(
      problem::System(
          {.damping = 0, .stiffness = 0},
          {.left = 0, .left_restitution = restitution, .right = 2, .right_restitution = 0.5}),
      1);
}

const FiniteVolumeOptions kWhite{.equation = DensityEquation::white, .max_seconds = 200};

// By symmetry y = |x| leaves (0, 1) when x leaves (-1, 1).
TEST(Passage, HasTheExactMeanTimesFromAWallUnderNoise) {
  for (const double y : {0.0, 0.5}) {
    const FirstPassageResult passage =
        solve_passage(random_acceleration(1), kWhite, {.level = 1}, {1}, {{y, 0}});
    ASSERT_EQ(passage.status, Status::ok) << passage.reason;
    const double exact = exact::random_acceleration_exit_time(0.5 + y / 2, 2, 0.5);
    EXPECT_NEAR(passage.mean_from_point->value, exact, 1e-4 * exact) << y;
    EXPECT_LE(std::abs(passage.mean_from_point->value - exact), passage.mean_from_point->error);
    EXPECT_LE(passage.mean_from_point->error, 1e-3 * exact);
  }
}

// Returns the mean time and its standard error from (0, 0) to y = 1 of x'' = xi with the intensity
// 2D = 1 and a wall at 0. The Gaussian increments of y and v are exact. The steps in time are short
// near the wall and the barrier; in a step at the wall the velocity changes by about a tenth.
ValueWithError simulated_exit_time(double restitution, int paths) {
  constexpr double kOfScale = 0.01, kShortestStep = 1e-5, kLongestStep = 5e-3;
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  double sum = 0, square = 0;
  for (int path = 0; path < paths; ++path) {
    double t = 0, y = 0, v = 0;
    while (y < 1) {
      const double distance = std::min(y, 1 - y);
      const double h = std::clamp(kOfScale * std::max(std::cbrt(distance * distance), v * v),
                                  kShortestStep, kLongestStep);
      const double a = normal(engine), b = normal(engine);
      const double change = std::sqrt(h) * a;
      const double next = y + v * h + std::sqrt(h * h * h) * (a / 2 + b / std::sqrt(12));
      if (next < 0) {  // impact at a part of the step, with the velocity there
        const double part = y / (y - next);
        t += part * h;
        v = -restitution * std::min(0.0, v + part * change);
        y = 0;
        continue;
      }
      t += next < 1 ? h : h * (1 - y) / (next - y);
      y = next;
      v += change;
    }
    sum += t;
    square += t * t;
  }
  const double mean = sum / paths;
  return {mean, std::sqrt((square / paths - mean * mean) / paths)};
}

TEST(Passage, HasInelasticImpacts) {
  constexpr int kPaths = 10000;
  const double exact = exact::random_acceleration_exit_time(0.5, 2, 0.5);
  const ValueWithError elastic = simulated_exit_time(1, kPaths);
  EXPECT_NEAR(elastic.value, exact, 3 * elastic.error);
  const ValueWithError simulated = simulated_exit_time(0.5, kPaths);
  const FirstPassageResult passage =
      solve_passage(random_acceleration(0.5), kWhite, {.level = 1}, {1}, {{0, 0}});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_NEAR(passage.mean_from_point->value, simulated.value, 3 * simulated.error);
  EXPECT_LE(simulated.error, 0.01 * simulated.value);
  EXPECT_LE(passage.mean_from_point->error, 2e-3 * simulated.value);
}

// The walls beyond the barriers shift the wall coordinates.
TEST(PassageOfTwoBarriers, HasTheExactValuesOfTheRandomAccelerationProcess) {
  const problem::Problem p = tests::with_noise(
      problem::System({.damping = 0, .stiffness = 0},
                      {.left = -1, .left_restitution = 0.5, .right = 2, .right_restitution = 0.5}),
      1);
  const transform::PassageBarrier barriers{.level = 1, .lower_level = 0};
  const FirstPassageResult passage = solve_passage(p, kWhite, barriers, {1}, {{0.25, 0}});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  expect_value(passage.mean_from_point, exact::random_acceleration_exit_time(0.25, 1, 0.5), "mean");
  expect_value(passage.upper_exit_from_point, boost::math::ibeta(1. / 6, 1. / 6, 0.25), "exit");
  expect_value(passage.upper_exit_from_stationary, 0.5, "exit from stationary");
  // The rate of exits is the loss of the survival probability at t = 0.
  EXPECT_LT(passage.rice_rate->value / passage.probability_below->value, passage.hazard->value);
  const FirstPassageResult km4 =
      solve_passage(p, {.equation = DensityEquation::km4}, barriers, {1}, {{0.25, 0}});
  EXPECT_EQ(km4.status, Status::not_offered);
}

// The mass rests at the wall, outside the interval.
TEST(PassageOfTwoBarriers, HasNoStartAtRestOutsideTheInterval) {
  const FirstPassageResult passage =
      solve_passage(tests::paper_case(1), {.equation = DensityEquation::white, .accuracy = 0.1},
                    {.level = 1.5, .lower_level = 0.2}, {1});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_FALSE(passage.mean_from_point);
  EXPECT_FALSE(passage.upper_exit_from_point);
}

// The mirror images of two wells: a rest point below the lower barrier does not count.
TEST(PassageOfTwoBarriers, StartsAtRestInTheIntervalOfEachWell) {
  const problem::Problem p =
      tests::with_noise(problem::System({.damping = 0.5, .stiffness = -1, .cubic = 1},
                                        problem::WallParameters{.none = true}),
                        0.3);
  const FiniteVolumeOptions options{.accuracy = 0.1, .max_seconds = 200};
  const auto left = solve_passage(p, options, {.level = -0.2, .lower_level = -1.6}, {1}),
             right = solve_passage(p, options, {.level = 1.6, .lower_level = 0.2}, {1});
  ASSERT_TRUE(left.mean_from_point && right.mean_from_point) << left.reason << right.reason;
  EXPECT_NEAR(left.mean_from_point->value, right.mean_from_point->value,
              1e-3 * left.mean_from_point->value);
  EXPECT_NEAR(left.upper_exit_from_point->value, 1 - right.upper_exit_from_point->value, 1e-3);
}

// Finite differences have the exact impact condition alone.
TEST(Passage, UsesTheImpactConditionOfTheMethod) {
  const auto p = tests::make_problem({.restitution = 0.8});
  FiniteVolumeOptions options{.equation = DensityEquation::white, .accuracy = 0.1};
  const auto exact = solve_passage(p, options, {.level = 1}, {1});
  options.impact = problem::ImpactCondition::delta;
  const auto first_order = solve_passage(p, options, {.level = 1}, {1});
  ASSERT_TRUE(exact.hazard && first_order.hazard) << first_order.reason;
  EXPECT_GT(std::abs(first_order.hazard->value / exact.hazard->value - 1), 0.02);
  EXPECT_EQ(solve_passage(p, options, {.level = 1, .lower_level = 0.5}, {1}).status,
            Status::not_offered);
}

// With 121 x 182 nodes the hazard is 0.12535, and increases by less than 4e-5 from there. The error
// of the first three grids by the order 2 would be 1.8e-4.
TEST(PassageOfTwoBarriers, StatesErrorsOfOrderOneWithoutNoise) {
  const problem::Problem p = tests::with_impulses(
      problem::System({.damping = 0.2, .stiffness = 1}, {.none = true}),
      problem::ImpulseTrain({.arrival_rate = 0.6, .law = "uniform", .intensity = 0.1, .mean = 0}));
  const FirstPassageResult passage = solve_passage(p, {.accuracy = 0.1, .max_seconds = 200},
                                                   {.level = 0.5, .lower_level = -0.6}, {3});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_NEAR(passage.hazard->value, 0.12537, passage.hazard->error);
  EXPECT_GT(passage.hazard->error, 4e-4);
  EXPECT_LT(passage.hazard->error, 1e-3);
}

// The hazard of passages over 2.2 is 4e-8 (`fpkcheck passage bistable --displacement 2.2 --methods
// mcs`), below the error of finite differences.
TEST(Passage, StatesThatPassagesAreTooRare) {
  const problem::Problem p =
      tests::with_noise(problem::System({.damping = 0.2, .stiffness = -1, .cubic = 1},
                                        problem::WallParameters{.none = true}),
                        0.1);
  const FirstPassageResult passage = solve_passage(p, {.max_seconds = 4}, {.level = 2.2}, {240});
  EXPECT_EQ(passage.status, Status::inaccurate);
  EXPECT_NE(passage.reason.find("rare passages"), std::string::npos) << passage.reason;
}

// The matrix of 240 x 360 nodes would have 3e7 elements. With an expired deadline the stationary
// density, which the solver computes before the matrix, gives another reason.
TEST(PassageOfTwoBarriers, RefusesALargeGridBeforeAnyComputation) {
  const problem::Problem p =
      tests::with_impulses(problem::System({.damping = 0.1, .stiffness = 1}, {.none = true}),
                           tests::gaussian_impulses(2, 0.4));
  const problem::MotionScales scales = problem::motion_scales(p);
  const FiniteVolumeOptions options;
  const DisplacementPassageProblem passage{.problem = p,
                                           .options = options,
                                           .scales = scales,
                                           .barrier = 1,
                                           .lower_barrier = -1,
                                           .start = {},
                                           .waiting_rate = 0,
                                           .box = {.x1_max = 6, .x2_max = 6, .x1_min = -6}};
  const base::Deadline expired(1e-9);
  const auto failure_on_grid = [&](double refinement) {
    return barrier_passage_on_grid(passage, refinement, {1}, expired).values_on_grid.failure;
  };
  EXPECT_NE(failure_on_grid(3).find("memory"), std::string::npos) << failure_on_grid(3);
  EXPECT_NE(failure_on_grid(1).find("max_seconds"), std::string::npos) << failure_on_grid(1);
}

// Noise ends the rest at once. The simulation (mcs-white) gives 0.2790 +- 0.0004 for the start at
// (0.5, 2), which moves towards the barrier, and 1.98 +- 0.07 for (0.5, -2), which first impacts
// the wall.
TEST(Passage, StartsAtAGivenState) {
  const auto p = tests::make_problem({.damping = 0.3, .intensity = 0.3});
  const FiniteVolumeOptions white{.equation = DensityEquation::white, .accuracy = 0.1};
  const FirstPassageResult rest = solve_passage(p, white, {.level = 1}, {10});
  const FirstPassageResult at_wall =
      solve_passage(p, white, {.level = 1}, {10}, transform::PassageStartState{0, 0});
  ASSERT_EQ(rest.status, Status::ok) << rest.reason;
  EXPECT_DOUBLE_EQ(at_wall.mean_from_point->value, rest.mean_from_point->value);
  const FirstPassageResult up =
      solve_passage(p, white, {.level = 1}, {10}, transform::PassageStartState{0.5, 2});
  const FirstPassageResult down =
      solve_passage(p, white, {.level = 1}, {10}, transform::PassageStartState{0.5, -2});
  EXPECT_NEAR(up.mean_from_point->value, 0.279, 0.01);
  EXPECT_NEAR(down.mean_from_point->value, 1.98, 0.2);
}

// The wall at y = -0.3 shifts the map, and the interval of y differs from the interval of y'.
TEST(MeanTimeMap, HasTheMeanTimeOfAStartInItsCell) {
  std::istringstream ini(
      "[system]\ndamping = 0.3\nstiffness = 1\n[wall]\nleft = -0.3\nleft_restitution = 1\n"
      "[noise]\nintensity = 0.3\n");
  const problem::Problem p = problem::read_case(ini, "test", "test.ini");
  const FiniteVolumeOptions white{.equation = DensityEquation::white, .accuracy = 0.1};
  const transform::PassageStartState start{-0.1, -1};
  const FirstPassageResult passage = solve_passage(p, white, {.level = 1}, {10}, start);
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  const auto& map = passage.mean_passage_times_by_start.value();
  EXPECT_NEAR(map.y_edges.front(), -0.3, 1e-12);
  EXPECT_NEAR(map.y_edges.back(), 1, 1e-12);
  const auto cell = [](const std::vector<double>& edges, double x) {
    return static_cast<std::size_t>(std::ranges::upper_bound(edges, x) - edges.begin() - 1);
  };
  const std::size_t index =
      cell(map.y_edges, start.y) * (map.v_edges.size() - 1) + cell(map.v_edges, start.ydot);
  const double value = passage.mean_from_point->value;
  EXPECT_NEAR(map.averages.at(index), value, 0.05 * value);
}

TEST(Passage, RefusesABarrierOutsideTheWalls) {
  EXPECT_EQ(solve_passage(tests::paper_case(1), {}, {.level = -1}, {}).status, Status::not_offered);
}

// The mass below the barrier decreases by the flux of outgoing motion alone.
TEST(Barrier, AbsorbsTheOutgoingMotionAlone) {
  const problem::Problem p = tests::paper_case(1);
  const PlaneDiscretisation on = discretise_density_equation(
      p, {.nx = 24, .nv = 40}, {.x1_max = 1.5, .x2_max = 4, .x1_min = 0});
  const PhasePlaneGrid below{on.grid.x1.with_right_end_condition(AxisEndCondition::barrier),
                             on.grid.x2};
  FiniteVolumeOptions options;
  const auto op = fokker_planck_operator(
      p, options,
      discretise_excitation_on_same_grid(p, options, {.grid = below, .excitation = {}}));
  const Eigen::VectorXd density = gaussian_cell_averages(
      {.displacement_deviation = 1, .velocity_deviation = 0.7, .mean_velocity = 0.2}, below);
  const double outflow = wall_speed_moment(below, density, 5, 1, AxisEnd::right);
  ASSERT_GT(outflow, 0.01);
  EXPECT_NEAR(op.total_mass(op * density), -outflow, 1e-12);
}

TEST(TransposedOperator, IsTheAdjoint) {
  const problem::Problem p = tests::make_problem({.restitution = 0.8, .mean = 0.1});
  const PlaneDiscretisation on =
      discretise_density_equation(p, {.nx = 20, .nv = 32}, {.x1_max = 4, .x2_max = 4});
  const auto op = fokker_planck_operator(p, {}, on);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(on.grid.size()),
                        y = Eigen::VectorXd::Random(on.grid.size());
  EXPECT_NEAR(y.dot(op * x), op.transposed_product(y).dot(x), 1e-10 * y.norm() * x.norm());
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
