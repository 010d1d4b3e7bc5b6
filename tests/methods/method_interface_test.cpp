#include "methods/method_interface.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "general_oscillators.hpp"
#include "methods/builtin_solvers.hpp"

namespace fpkcheck::methods {
namespace {

using problem::System;
using problem::WallParameters;
using transform::StateVariable;

WallParameters between(double left, double right) {
  return {.left = left, .left_restitution = 0.9, .right = right, .right_restitution = 0.8};
}

// In floating point y - a + a differs from y for most walls a. The bins and intervals of a
// histogram must nevertheless be exactly those of the axes.
TEST(SolveInWallCoordinates, MarginalsOfASimulationHaveTheExactAxes) {
  std::vector<WallParameters> all{between(-1, 1.2), between(-0.6, 0.8)};
  for (int k = -4; k <= 4; ++k) {
    const double at = 0.1 + 0.237 * k;
    all.push_back({.left = at, .left_restitution = 0.8});
    all.push_back({.right = at, .right_restitution = 0.8});
    all.push_back(between(at, at + 1.3));
  }
  const auto method =
      builtin_registry().find_method_by_id("mcs", {{"time", 1.0}, {"streams", std::int64_t{8}}});
  ASSERT_TRUE(method);
  for (const WallParameters& walls : all) {
    const auto problem =
        tests::with_impulses(System({.damping = 0.4, .stiffness = 1, .cubic = 0.1}, walls),
                             tests::gaussian_impulses(1, 0.2));
    const auto axes = compare::comparison_bins(problem);
    const auto solution = method->solve(problem, {axes, {}});
    SCOPED_TRACE(problem::non_default_parameters_text(problem));
    for (const auto variable : transform::kVariables) {
      const auto marginal =
          transform::marginal(solution, variable, compare::comparison_bin_edges(axes, variable));
      EXPECT_EQ(marginal.lower.size(), marginal.size()) << transform::name(variable);
      EXPECT_EQ(marginal.upper.size(), marginal.size()) << transform::name(variable);
    }
    const auto* histogram = std::get_if<transform::GridDensity>(&*solution.density);
    ASSERT_NE(histogram, nullptr);
    EXPECT_EQ(histogram->y_edges, axes.y_edges);
    EXPECT_EQ(histogram->v_edges, axes.v_edges);
  }
}

}  // namespace
}  // namespace fpkcheck::methods
