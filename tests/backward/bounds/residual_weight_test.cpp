#include "backward/bounds/residual_weight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/closed_forms.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::backward {
namespace {

problem::Problem linear_case(const std::string& law) {
  return problem::load_case("case1",
                            {"system.cubic=0", "system.restitution=1", "impulse.law=" + law});
}

// Moments E[z^p v^q], p + q = 4, computed from cumulants of a symmetric law.
double fourth_moment(const problem::Problem& problem, int p) {
  const auto second = [&](bool a, bool b) {  // true for z, false for v
    return exact::linear_cumulant(problem, a + b, 2 - a - b);
  };
  const bool z[4] = {p > 0, p > 1, p > 2, p > 3};
  return exact::linear_cumulant(problem, p, 4 - p) + second(z[0], z[1]) * second(z[2], z[3]) +
         second(z[0], z[2]) * second(z[1], z[3]) + second(z[0], z[3]) * second(z[1], z[2]);
}

TEST(EnergyMomentBounds, BoundTheExactMomentsOfLinearMotion) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    const problem::Problem problem = linear_case(law);
    const std::vector<double> bounds = energy_moment_bounds(problem, 2);
    const double c = problem.system.damping(), k = problem.system.stiffness();
    // G = a v^2 + b y v + d y^2; y v and the squares are the same functions of (z, z').
    const double a = 0.5, b = c / 2, d = k / 2;
    const double first = a * exact::linear_cumulant(problem, 0, 2) +
                         b * exact::linear_cumulant(problem, 1, 1) +
                         d * exact::linear_cumulant(problem, 2, 0);
    const double second = a * a * fourth_moment(problem, 0) +
                          2 * a * b * fourth_moment(problem, 1) +
                          (b * b + 2 * a * d) * fourth_moment(problem, 2) +
                          2 * b * d * fourth_moment(problem, 3) + d * d * fourth_moment(problem, 4);
    EXPECT_EQ(bounds[0], 1);
    EXPECT_NEAR(bounds[1], first, 1e-9) << law;  // r = 1 and mu = 0: G decays at exactly rate c
    EXPECT_GE(bounds[1], first - 1e-9) << law;
    EXPECT_GE(bounds[2], second) << law;
    EXPECT_LT(bounds[2], 2 * second) << law;
  }
}

TEST(EnergyMomentBounds, WithAMeanSolveTheQuadraticInequality) {
  // c x = lambda E[Y^2]/2 + lambda |E[Y]| sqrt(2 x)
  const problem::Problem problem = problem::load_case("case1", {"impulse.mean=-0.1"});
  const double x = energy_moment_bounds(problem, 1)[1];
  EXPECT_NEAR(0.1 * x, 0.05 + 0.1 * std::sqrt(2 * x), 1e-12);
}

TEST(ResidualWeight, EnergyDecaysAlongTheFlowAndAtImpacts) {
  const problem::Problem problem = problem::load_case("case1", {"system.damping=0.9"});
  const ResidualWeightFunctionOfEnergy weight = make_residual_weight(problem, 12);
  for (const double y : {0.01, 0.3, 2.0}) {
    for (const double v : {-3.0, -0.2, 0.0, 0.5, 4.0}) {
      const double h = 1e-5, force = problem.system.restoring_force()(y);
      const double slope_y = (weight.energy(y + h, v) - weight.energy(y - h, v)) / (2 * h);
      const double slope_v = (weight.energy(y, v + h) - weight.energy(y, v - h)) / (2 * h);
      const double rate = v * slope_y - (0.9 * v + force) * slope_v;
      EXPECT_NEAR(rate, -0.9 * weight.energy(y, v) - 0.9 * 0.1 * std::pow(y, 4) / 4, 1e-7);
    }
  }
  EXPECT_LE(weight.energy(0, 0.98 * 2), weight.energy(0, -2));
}

TEST(ResidualWeight, HasItsDesignMean) {
  const ResidualWeightFunctionOfEnergy weight =
      make_residual_weight(problem::load_case("case1"), 12);
  EXPECT_NEAR(weight.mean_upper_bound, 1.25, 1e-12);
  EXPECT_NEAR(weight(0, std::sqrt(2 * weight.energy_scale)), 2, 1e-12);
}

TEST(ResidualWeight, RejectsLawsWithoutEnclosures) {
  EXPECT_EQ(bounds_unsupported_reason(problem::load_case("case1", {"impulse.law=exponential"})),
            "");
  EXPECT_EQ(bounds_unsupported_reason(problem::load_case("case1", {"impulse.law=gamma"})),
            "gamma impulses are not supported: no enclosures of the law");
}

TEST(ResidualWeight, RejectsOverdampedMotionWithOneLine) {
  EXPECT_EQ(bounds_unsupported_reason(problem::load_case("case1")), "");
  EXPECT_EQ(bounds_unsupported_reason(problem::load_case("case1", {"system.damping=1.999"})), "");
  for (const char* damping : {"system.damping=2", "system.damping=3"}) {
    const std::string reason = bounds_unsupported_reason(problem::load_case("case1", {damping}));
    EXPECT_NE(reason.find("c^2 >= 4k"), std::string::npos) << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace fpkcheck::backward
