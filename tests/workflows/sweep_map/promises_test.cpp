#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <iostream>

#include "methods/builtin_solvers.hpp"
#include "problem/problem.hpp"
#include "thorough.hpp"
#include "workflows/sweep/execution/solve_point.hpp"
#include "workflows/sweep/map/method_advice.hpp"

// Reliability of the promises of the shipped map (docs/validity.md).
namespace fpkcheck::sweep {
namespace {

// Each point of the map with the promises made by all other points; the recommended method is
// checked.
struct LeftOut {
  int points = 0, promised = 0, approximate = 0;
  int said = 0, missed = 0;  // not ok; ok, but L1 above the accuracy
  double worst = 0;          // largest L1 in units of the accuracy
};

LeftOut left_out(double accuracy) {
  LeftOut found;
  ValidityMap map = shipped_validity_map();
  for (auto& point : map.points) {
    const ValidityMapCoordinates coordinates = point.coordinates;
    point.coordinates.law = "left out";
    const auto promised =
        recommend_methods(coordinates, accuracy, map).sufficiently_accurate_methods();
    point.coordinates = coordinates;
    ++found.points;
    if (promised.empty()) continue;
    ++found.promised;
    const auto m = std::ranges::find(map.methods, promised.front().id) - map.methods.begin();
    const auto& answer = point.method_results[static_cast<std::size_t>(m)];
    if (!answer || promised.front().id == map.methods.back()) continue;
    ++found.approximate;
    found.said += answer->has_status_ok() ? 0 : 1;
    if (!answer->has_status_ok() || *answer->l1 < accuracy) continue;
    ++found.missed;
    found.worst = std::max(found.worst, *answer->l1 / accuracy);
  }
  return found;
}

TEST(Promises, HoldAtPointsThatAreLeftOut) {
  std::cout << "accuracy  points  promised  not by fd-kf  not ok  ok, but off  at most\n";
  for (const double accuracy : {0.02, 0.01, 0.005, 0.002, 0.001}) {
    const auto found = left_out(accuracy);
    std::cout << fmt::format("{:<8g}  {:>6}  {:>8}  {:>12}  {:>6}  {:>11}  {:>7}\n", accuracy,
                             found.points, found.promised, found.approximate, found.said,
                             found.missed,
                             found.missed > 0 ? fmt::format("{:.2g}", found.worst) : "-");
    EXPECT_LE(found.said + found.missed, 0.005 * found.approximate);
    EXPECT_LT(found.worst, 2);
  }
}

// A random problem within the box of the plans, in random units.
problem::Problem problem_inside(std::uint64_t number) {
  boost::random::mt19937_64 engine(number);
  boost::random::uniform_01<double> unit;
  const auto log_between = [&](double from, double to) {
    return from * std::pow(to / from, unit(engine));
  };
  const double time = log_between(0.1, 10), length = log_between(0.1, 10);
  const double restitution = 0.6 + 0.4 * unit(engine);
  const double damping = log_between(0.02, 0.4), cubic = log_between(0.01, 10);
  const double rate = log_between(0.2, 20);
  return {.name = fmt::format("inside{}", number),
          .system = problem::System({.damping = damping / time,
                                     .stiffness = 1 / (time * time),
                                     .cubic = cubic / (time * time * length * length),
                                     .restitution = restitution}),
          .impulses = problem::ImpulseTrain({.arrival_rate = rate / time,
                                             .law = "gaussian",
                                             .intensity = 0.1 * length * length / std::pow(time, 3),
                                             .mean = 0})};
}

TEST(Promises, HoldForProblemsBetweenThePoints) {
  constexpr double kAccuracy = 0.01;
  const int wanted = tests::is_thorough() ? 40 : 6;
  int solved = 0;
  for (std::uint64_t number = 1; solved < wanted && number < 1000; ++number) {
    const auto problem = problem_inside(number);
    const auto promised = recommend_methods(problem, kAccuracy, shipped_validity_map())
                              .sufficiently_accurate_methods();
    if (promised.empty() || promised.front().id == "fd-kf") continue;
    SCOPED_TRACE(problem.name + ": " + problem::non_default_parameters_text(problem));
    const std::string id = promised.front().id;
    SweepPlan plan{.base = problem, .axes = {}, .points = {{}}};
    plan.methods = methods::builtin_registry().methods_selected_by_list(
        id + ",fd-kf", {{"stepper", std::string("direct")}});
    const auto result = solve_sweep_point(plan, 0).result;
    ASSERT_EQ(result.reference, "fd-kf");
    const auto& closure = result.methods.front();
    EXPECT_EQ(closure.status, transform::Status::ok) << id << ": " << closure.reason;
    ASSERT_TRUE(closure.l1) << id;
    EXPECT_LT(std::max(closure.l1->y, closure.l1->ydot), kAccuracy) << id;
    std::cout << fmt::format("{}: {} off by {:.2g}, {:.2g} s\n", problem.name, id,
                             std::max(closure.l1->y, closure.l1->ydot), closure.seconds);
    ++solved;
  }
  EXPECT_EQ(solved, wanted);
}

}  // namespace
}  // namespace fpkcheck::sweep
