#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "backward/bounds/bounds.hpp"
#include "backward/bounds/residual_bounds.hpp"
#include "backward/generator/collocation.hpp"
#include "backward/residual/density_residuals.hpp"
#include "exact/closed_forms.hpp"
#include "general_oscillators.hpp"

namespace fpkcheck::backward {
namespace {

using problem::SystemCoefficients;
using problem::WallParameters;

const SystemCoefficients kLinear{.damping = 0.2, .stiffness = 1};

problem::Problem driven(const SystemCoefficients& system, const WallParameters& walls,
                        const std::string& law = "gaussian", double mean = 0) {
  return tests::with_impulses(
      problem::System(system, walls),
      problem::ImpulseTrain({.arrival_rate = 1, .law = law, .intensity = 0.1, .mean = mean}));
}

numerics::Enclosure bound_of(const GuaranteedBounds& bounds, const std::string& of) {
  for (const FunctionalBounds& b : bounds.each) {
    if (name(b.functional) == of) return b.value;
  }
  ADD_FAILURE() << "no bounds of " << of;
  return {0, 0};
}

GuaranteedBounds first_grid(const problem::Problem& problem) {
  Options options;
  options.seconds = 0;
  return compute_bounds(problem, options);
}

TEST(FamilyBounds, WithoutAWallContainTheCumulants) {
  for (const char* law : {"laplace", "two_point"}) {
    const auto problem = driven(kLinear, {.none = true}, law, 0.1);
    const auto found = first_grid(problem);
    EXPECT_EQ(found.status, BoundsStatus::ok) << found.reason;
    ASSERT_EQ(found.each.size(), 5u);  // without the impact momentum w1
    const auto kappa = [&](int p, int q) { return exact::linear_cumulant(problem, p, q); };
    const double y = kappa(1, 0);
    const std::vector<std::pair<std::string, double>> known{
        {"E[y]", y},
        {"E[y^2]", kappa(2, 0) + y * y},
        {"E[y'^2]", kappa(0, 2)},
        {"E[y'^4]", kappa(0, 4) + 3 * kappa(0, 2) * kappa(0, 2)},
        {"E[y^4]", kappa(4, 0) + 3 * kappa(2, 0) * kappa(2, 0) + 4 * kappa(3, 0) * y +
                       6 * kappa(2, 0) * y * y + std::pow(y, 4)}};
    for (const auto& [of, value] : known) {
      const auto bound = bound_of(found, of);
      EXPECT_TRUE(bound.contains(value))
          << law << ' ' << of << ' ' << value << " in " << bound.lower << ' ' << bound.upper;
      EXPECT_LT(bound.half_width(), 1e-2 * value) << law << ' ' << of;
    }
  }
}

TEST(FamilyBounds, WithoutLossesContainTheMeanSquareVelocityForAnyWalls) {
  const SystemCoefficients duffing{.damping = 0.1, .stiffness = 1, .cubic = 0.3};
  for (const WallParameters& walls :
       {WallParameters{.left = -0.5, .left_restitution = 1},
        WallParameters{.right = 0.4, .right_restitution = 1},
        WallParameters{.left = -0.5, .left_restitution = 1, .right = 1, .right_restitution = 1},
        WallParameters{.none = true}, WallParameters{.left = -90, .left_restitution = 0.5}}) {
    const auto bound = bound_of(first_grid(driven(duffing, walls)), "E[y'^2]");
    EXPECT_TRUE(bound.contains(0.5)) << bound.lower << ' ' << bound.upper;  // lambda E[Y^2] / 2c
    EXPECT_LT(bound.half_width(), 1e-3);
  }
}

TEST(FamilyBounds, OfAGapContainTheCorrectedMoments) {
  const auto problem = driven({.damping = 0.1, .stiffness = 1, .cubic = 0.1},
                              {.left = -0.5, .left_restitution = 0.9});
  const auto bell = [](double x, double v) { return std::exp(-(x - 0.7) * (x - 0.7) - v * v); };
  const auto known = DensityResiduals(tests::in_wall_coordinates(problem), {.y = 28, .v = 60})
                         .estimate_errors(transform::SmoothDensity{bell, 5, 5})
                         .corrected;
  const auto found = first_grid(problem);
  EXPECT_TRUE(bound_of(found, "E[y]").contains(known.y1)) << known.y1;
  EXPECT_TRUE(bound_of(found, "E[y^2]").contains(known.y2)) << known.y2;
  EXPECT_TRUE(bound_of(found, "E[y'^2]").contains(known.v2)) << known.v2;
  EXPECT_TRUE(bound_of(found, "E[y^4]").contains(known.y4)) << known.y4;
  EXPECT_TRUE(bound_of(found, "E[y'^4]").contains(known.v4)) << known.v4;
  EXPECT_LT(bound_of(found, "E[y'^2]").half_width(), 0.1 * known.v2);
}

TEST(FamilyBounds, OfTheMirroredProblemAreMirrored) {
  const auto left = first_grid(
                 driven(kLinear, {.left = -0.3, .left_restitution = 0.9}, "laplace", 0.05)),
             right = first_grid(
                 driven(kLinear, {.right = 0.3, .right_restitution = 0.9}, "laplace", -0.05));
  for (const char* of : {"E[y^2]", "E[y'^2]", "E[y^4]", "w1"}) {
    EXPECT_EQ(bound_of(left, of).lower, bound_of(right, of).lower) << of;
    EXPECT_EQ(bound_of(left, of).upper, bound_of(right, of).upper) << of;
  }
  EXPECT_EQ(bound_of(left, "E[y]").lower, -bound_of(right, "E[y]").upper);
  EXPECT_EQ(bound_of(left, "E[y]").upper, -bound_of(right, "E[y]").lower);
}

TEST(FamilyBounds, HaveAReasonForUnsupportedProblems) {
  const auto refused = [](const problem::Problem& problem, const char* why) {
    const GuaranteedBounds found = compute_bounds(problem);
    EXPECT_EQ(found.status, BoundsStatus::not_offered) << why;
    EXPECT_NE(found.reason.find(why), std::string::npos) << found.reason;
  };
  refused(tests::with_noise(problem::System(kLinear, {.none = true}), 0.1), "white noise");
  refused(driven({.damping = -0.1, .van_der_pol = 0.1, .stiffness = 1}, {.none = true}),
          "constant damping");
  refused(driven({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true}), "c^2 >= 4k");
  refused(driven({.damping = 0.1, .constant = 0.1, .stiffness = 1}, {.none = true}), "k y + mu");
  refused(driven(kLinear, {.left = 0.1, .left_restitution = 0.9}), "presses");
  refused(
      driven(kLinear, {.left = -1, .left_restitution = 0.9, .right = 1, .right_restitution = 1}),
      "two walls");
}

// A problem without a wall, and an inaccurate certificate with a large residual.
struct OpenExample {
  problem::Problem problem =
      driven({.damping = 0.3, .stiffness = 1, .cubic = 0.2}, {.none = true}, "gaussian", 0.05);
  ResidualWeight tau = residual_weight(problem, 12);
  numerics::SplineBasis displacement{std::vector<double>{-3.5, -2, -0.5, 0.4, 2, 4}};
  ImpactBasis velocity;
  DisplacementFactorEnclosures y = numerics::call_with_upward_rounding(
      [&] { return enclose_displacement_factors(problem, displacement, {}); });
  VelocityFactorEnclosures v = numerics::call_with_upward_rounding(
      [&] { return enclose_velocity_factors(problem, velocity, {}); });
  Eigen::MatrixXd c{displacement.size(), velocity.size()};

  explicit OpenExample(double u_end = 4.5)
      : velocity(numerics::SplineBasis(numerics::graded_breaks(u_end, 5, 0.1, 1)), 1) {
    for (int a = 0; a < c.rows(); ++a) {
      for (int b = 0; b < c.cols(); ++b)
        c(a, b) = std::sin(0.9 * a + 0.5) * std::cos(0.4 * b + 0.3);
    }
  }
  CertificateCheckInputs context(const BoxEndTypes& ends) const {
    return {problem, displacement, velocity, y, v, tau, ends};
  }
};

constexpr BoxEndTypes kOpen{
    .left_wall = false, .right_wall = false, .left_open = true, .right_open = true};

TEST(FamilyBounds, RequireTheImpactConditionAtEveryWall) {
  OpenExample e;
  const Functional f = PowerMoment{Axis::displacement, 2};
  const auto finite = [&](const BoxEndTypes& ends) {
    const ResidualRange range = numerics::call_with_upward_rounding([&] {
      return residual_range(e.context(ends), f, {e.c, 0.3}, {0, 0}, 0.05);
    });
    return std::isfinite(range.largest - range.least);
  };
  EXPECT_TRUE(finite(kOpen));
  EXPECT_FALSE(finite({.left_wall = true, .right_wall = false}));
  EXPECT_FALSE(finite({.left_wall = false, .right_wall = true}));
  for (int b = 0; b < e.c.cols(); ++b) e.c(0, b) = e.c(0, e.velocity.mirrored_index(b));
  EXPECT_TRUE(finite({.left_wall = true, .right_wall = false}));
}

TEST(FamilyBounds, InnerAndOuterResidualsBoundAllSamples) {
  const OpenExample e;
  const Functional f = PowerMoment{Axis::displacement, 4};
  const auto context = e.context(kOpen);
  const ResidualRange range = numerics::call_with_upward_rounding([&] {
    return residual_range(context, f, {e.c, 0.3}, {0, 0}, 0.02);
  });
  const double outside = numerics::call_with_upward_rounding([&] {
    return outer_residual_bound(context, f, {e.c, 0.3});
  });
  const VelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.v, e.velocity, 9); });
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 12);
  double least = 0, largest = 0;
  for (std::size_t i = 0; i < ys.y.size(); ++i) {
    const Eigen::MatrixXd local = ys.values[i] * e.c.middleRows(ys.span[i], 7);
    const Eigen::VectorXd l =
        vs.jump * local.row(0).transpose() + vs.drift * local.row(1).transpose() +
        e.problem.system.restoring_force()(ys.y[i]) * (vs.force * local.row(0).transpose());
    for (std::size_t j = 0; j < vs.v.size(); ++j) {
      const double r =
          (std::pow(ys.y[i], 4) + l(static_cast<int>(j)) - 0.3) / e.tau(ys.y[i], vs.v[j]);
      least = std::min(least, r);
      largest = std::max(largest, r);
    }
    for (const double v : {-4.501, -6.0, -30.0, 4.501, 6.0, 30.0}) {
      const Eigen::VectorXd edge = v < 0 ? e.c.leftCols<1>() : e.c.rightCols<1>();
      const double slope = ys.values[i].row(1).dot(edge.segment(ys.span[i], 7));
      EXPECT_LE(std::abs(std::pow(ys.y[i], 4) + v * slope - 0.3) / e.tau(ys.y[i], v), outside);
    }
  }
  EXPECT_LE(range.least, least);
  EXPECT_GE(range.largest, largest);
  EXPECT_LT(range.largest, 1.1 * largest);
}

TEST(FamilyBounds, OuterResidualDependsOnTheEdgeAtEachOpenEnd) {
  // V is steep in v at one end only; f and all other terms are small.
  const Functional f = PowerMoment{Axis::displacement, 1};
  for (const double y : {-3.5001, 4.0001}) {
    OpenExample e(14);
    const Eigen::Index row = y < 0 ? 0 : e.c.rows() - 1;
    for (int b = 0; b < e.c.cols(); ++b) e.c(row, b) = 1e4 * std::sin(b);
    const double outside = numerics::call_with_upward_rounding([&] {
      return outer_residual_bound(e.context(kOpen), f, {e.c, 0.3});
    });
    const VelocityFactorSamples vs = numerics::call_with_upward_rounding(
        [&] { return sample_velocity_factors(e.v, e.velocity, 9); });
    const Eigen::VectorXd edge = e.c.row(row);
    const Eigen::VectorXd l =
        vs.jump * edge + e.problem.system.restoring_force()(y) * (vs.force * edge);
    double largest = 0;
    for (std::size_t j = 0; j < vs.v.size(); ++j) {
      const double r = y + l(static_cast<int>(j)) - 0.3;
      largest = std::max(largest, std::abs(r) / e.tau(y, vs.v[j]));
    }
    EXPECT_LE(largest, outside) << y;
    EXPECT_GT(largest, 0.02 * outside) << y;
  }
}

}  // namespace
}  // namespace fpkcheck::backward
