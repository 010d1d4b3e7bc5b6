#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "backward/bounds/bounds.hpp"
#include "backward/bounds/residual_bounds.hpp"
#include "backward/generator/generator_at_collocation_points.hpp"
#include "backward/residual/density_error_estimator.hpp"
#include "exact/closed_forms.hpp"
#include "general_oscillators.hpp"

namespace fpkcheck::backward {
namespace {

using problem::SystemCoefficients;
using problem::WallParameters;

const SystemCoefficients kLinear{.damping = 0.2, .stiffness = 1};

// Returns a problem under impulses with the given amplitude law.
problem::Problem problem_under_impulses(const SystemCoefficients& system,
                                        const WallParameters& walls,
                                        const std::string& law = "gaussian", double mean = 0) {
  return tests::with_impulses(
      problem::System(system, walls),
      problem::ImpulseTrain({.arrival_rate = 1, .law = law, .intensity = 0.1, .mean = mean}));
}

numerics::Enclosure enclosure_of(const GuaranteedBounds& bounds, const std::string& of) {
  for (const FunctionalBounds& b : bounds.functional_bounds) {
    if (functional_name(b.functional) == of) return b.enclosure;
  }
  ADD_FAILURE() << "no bounds of " << of;
  return {0, 0};
}

GuaranteedBounds bounds_on_first_grid(const problem::Problem& problem) {
  BoundsOptions options;
  options.time_limit_seconds = 0;
  return compute_guaranteed_bounds(problem, options);
}

TEST(FamilyBounds, WithoutAWallContainTheCumulants) {
  for (const char* law : {"laplace", "two_point"}) {
    const auto problem = problem_under_impulses(kLinear, {.none = true}, law, 0.1);
    const auto found = bounds_on_first_grid(problem);
    EXPECT_EQ(found.status, BoundsStatus::ok) << found.reason;
    ASSERT_EQ(found.functional_bounds.size(), 5u);  // without the impact momentum w1
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
      const auto bound = enclosure_of(found, of);
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
    const auto bound =
        enclosure_of(bounds_on_first_grid(problem_under_impulses(duffing, walls)), "E[y'^2]");
    EXPECT_TRUE(bound.contains(0.5)) << bound.lower << ' ' << bound.upper;  // lambda E[Y^2] / 2c
    EXPECT_LT(bound.half_width(), 1e-3);
  }
}

TEST(FamilyBounds, OfAGapContainTheCorrectedMoments) {
  const auto problem = problem_under_impulses({.damping = 0.1, .stiffness = 1, .cubic = 0.1},
                                              {.left = -0.5, .left_restitution = 0.9});
  const auto bell = [](double x, double v) { return std::exp(-(x - 0.7) * (x - 0.7) - v * v); };
  const auto known =
      DensityErrorEstimator(tests::in_wall_coordinates(problem), {.y_cells = 28, .v_cells = 60})
          .estimate_errors(transform::SmoothDensity{bell, 5, 5})
          .corrected_moments;
  const auto found = bounds_on_first_grid(problem);
  EXPECT_TRUE(enclosure_of(found, "E[y]").contains(known.y1)) << known.y1;
  EXPECT_TRUE(enclosure_of(found, "E[y^2]").contains(known.y2)) << known.y2;
  EXPECT_TRUE(enclosure_of(found, "E[y'^2]").contains(known.v2)) << known.v2;
  EXPECT_TRUE(enclosure_of(found, "E[y^4]").contains(known.y4)) << known.y4;
  EXPECT_TRUE(enclosure_of(found, "E[y'^4]").contains(known.v4)) << known.v4;
  EXPECT_LT(enclosure_of(found, "E[y'^2]").half_width(), 0.1 * known.v2);
}

TEST(FamilyBounds, OfTheMirroredProblemAreMirrored) {
  const auto left = bounds_on_first_grid(problem_under_impulses(
                 kLinear, {.left = -0.3, .left_restitution = 0.9}, "laplace", 0.05)),
             right = bounds_on_first_grid(problem_under_impulses(
                 kLinear, {.right = 0.3, .right_restitution = 0.9}, "laplace", -0.05));
  for (const char* of : {"E[y^2]", "E[y'^2]", "E[y^4]", "w1"}) {
    EXPECT_EQ(enclosure_of(left, of).lower, enclosure_of(right, of).lower) << of;
    EXPECT_EQ(enclosure_of(left, of).upper, enclosure_of(right, of).upper) << of;
  }
  EXPECT_EQ(enclosure_of(left, "E[y]").lower, -enclosure_of(right, "E[y]").upper);
  EXPECT_EQ(enclosure_of(left, "E[y]").upper, -enclosure_of(right, "E[y]").lower);
}

TEST(FamilyBounds, HaveAReasonForUnsupportedProblems) {
  const auto expect_unsupported = [](const problem::Problem& problem, const char* why) {
    const GuaranteedBounds found = compute_guaranteed_bounds(problem);
    EXPECT_EQ(found.status, BoundsStatus::not_offered) << why;
    EXPECT_NE(found.reason.find(why), std::string::npos) << found.reason;
  };
  expect_unsupported(tests::with_noise(problem::System(kLinear, {.none = true}), 0.1),
                     "white noise");
  expect_unsupported(
      problem_under_impulses({.damping = -0.1, .van_der_pol = 0.1, .stiffness = 1}, {.none = true}),
      "constant damping");
  expect_unsupported(
      problem_under_impulses({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true}),
      "c^2 >= 4k");
  expect_unsupported(
      problem_under_impulses({.damping = 0.1, .constant = 0.1, .stiffness = 1}, {.none = true}),
      "k y + mu");
  expect_unsupported(problem_under_impulses(kLinear, {.left = 0.1, .left_restitution = 0.9}),
                     "presses");
  expect_unsupported(
      problem_under_impulses(
          kLinear, {.left = -1, .left_restitution = 0.9, .right = 1, .right_restitution = 1}),
      "two walls");
}

// A problem without a wall, and an inaccurate certificate with a large residual.
struct CertificateWithoutWalls {
  problem::Problem problem = problem_under_impulses({.damping = 0.3, .stiffness = 1, .cubic = 0.2},
                                                    {.none = true}, "gaussian", 0.05);
  ResidualWeightFunctionOfEnergy weight = make_residual_weight(problem, 12);
  numerics::SplineBasis displacement{std::vector<double>{-3.5, -2, -0.5, 0.4, 2, 4}};
  ImpactSplineBasis velocity;
  GeneratorDisplacementFactorEnclosures displacement_factors = numerics::call_with_upward_rounding(
      [&] { return enclose_displacement_factors(problem, displacement, {}); });
  GeneratorVelocityFactorEnclosures velocity_factors = numerics::call_with_upward_rounding(
      [&] { return enclose_velocity_factors(problem, velocity, {}); });
  Eigen::MatrixXd coefficients{displacement.size(), velocity.size()};

  explicit CertificateWithoutWalls(double max_speed = 4.5)
      : velocity(numerics::SplineBasis(numerics::graded_break_points(max_speed, 5, 0.1, 1)), 1) {
    for (int a = 0; a < coefficients.rows(); ++a) {
      for (int b = 0; b < coefficients.cols(); ++b)
        coefficients(a, b) = std::sin(0.9 * a + 0.5) * std::cos(0.4 * b + 0.3);
    }
  }
  ResidualBoundInputs inputs(const DisplacementBoundaryTypes& ends) const {
    return {problem, displacement, velocity, displacement_factors, velocity_factors, weight, ends};
  }
};

constexpr DisplacementBoundaryTypes kOpenEnds{.has_left_wall = false,
                                              .has_right_wall = false,
                                              .is_left_end_open = true,
                                              .is_right_end_open = true};

TEST(FamilyBounds, RequireTheImpactConditionAtEveryWall) {
  CertificateWithoutWalls e;
  const StationaryFunctional f = PowerMoment{StateVariable::y, 2};
  const auto is_range_finite = [&](const DisplacementBoundaryTypes& ends) {
    const BackwardResidualRange range = numerics::call_with_upward_rounding([&] {
      return enclose_residual_range(e.inputs(ends), f, {e.coefficients, 0.3}, {0, 0}, 0.05);
    });
    return std::isfinite(range.largest - range.least);
  };
  EXPECT_TRUE(is_range_finite(kOpenEnds));
  EXPECT_FALSE(is_range_finite({.has_left_wall = true, .has_right_wall = false}));
  EXPECT_FALSE(is_range_finite({.has_left_wall = false, .has_right_wall = true}));
  for (int b = 0; b < e.coefficients.cols(); ++b)
    e.coefficients(0, b) = e.coefficients(0, e.velocity.basis_index_after_impact(b));
  EXPECT_TRUE(is_range_finite({.has_left_wall = true, .has_right_wall = false}));
}

TEST(FamilyBounds, InnerAndOuterResidualsBoundAllSamples) {
  const CertificateWithoutWalls e;
  const StationaryFunctional f = PowerMoment{StateVariable::y, 4};
  const auto inputs = e.inputs(kOpenEnds);
  const BackwardResidualRange range = numerics::call_with_upward_rounding([&] {
    return enclose_residual_range(inputs, f, {e.coefficients, 0.3}, {0, 0}, 0.02);
  });
  const double outside = numerics::call_with_upward_rounding([&] {
    return outer_residual_bound(inputs, f, {e.coefficients, 0.3});
  });
  const GeneratorVelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.velocity_factors, e.velocity, 9); });
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 12);
  double least = 0, largest = 0;
  for (std::size_t i = 0; i < ys.displacements.size(); ++i) {
    const Eigen::MatrixXd local =
        ys.values_and_slopes[i] * e.coefficients.middleRows(ys.knot_spans[i], 7);
    const Eigen::VectorXd l = vs.impulse_and_damping * local.row(0).transpose() +
                              vs.transport * local.row(1).transpose() +
                              e.problem.system.restoring_force()(ys.displacements[i]) *
                                  (vs.restoring_force * local.row(0).transpose());
    for (std::size_t j = 0; j < vs.velocities.size(); ++j) {
      const double r = (std::pow(ys.displacements[i], 4) + l(static_cast<int>(j)) - 0.3) /
                       e.weight(ys.displacements[i], vs.velocities[j]);
      least = std::min(least, r);
      largest = std::max(largest, r);
    }
    for (const double v : {-4.501, -6.0, -30.0, 4.501, 6.0, 30.0}) {
      const Eigen::VectorXd edge =
          v < 0 ? e.coefficients.leftCols<1>() : e.coefficients.rightCols<1>();
      const double slope = ys.values_and_slopes[i].row(1).dot(edge.segment(ys.knot_spans[i], 7));
      EXPECT_LE(std::abs(std::pow(ys.displacements[i], 4) + v * slope - 0.3) /
                    e.weight(ys.displacements[i], v),
                outside);
    }
  }
  EXPECT_LE(range.least, least);
  EXPECT_GE(range.largest, largest);
  EXPECT_LT(range.largest, 1.1 * largest);
}

TEST(FamilyBounds, OuterResidualDependsOnTheEdgeAtEachOpenEnd) {
  // V is steep in v at one end only; f and all other terms are small.
  const StationaryFunctional f = PowerMoment{StateVariable::y, 1};
  for (const double y : {-3.5001, 4.0001}) {
    CertificateWithoutWalls e(14);
    const Eigen::Index row = y < 0 ? 0 : e.coefficients.rows() - 1;
    for (int b = 0; b < e.coefficients.cols(); ++b) e.coefficients(row, b) = 1e4 * std::sin(b);
    const double outside = numerics::call_with_upward_rounding([&] {
      return outer_residual_bound(e.inputs(kOpenEnds), f, {e.coefficients, 0.3});
    });
    const GeneratorVelocityFactorSamples vs = numerics::call_with_upward_rounding(
        [&] { return sample_velocity_factors(e.velocity_factors, e.velocity, 9); });
    const Eigen::VectorXd edge = e.coefficients.row(row);
    const Eigen::VectorXd l = vs.impulse_and_damping * edge +
                              e.problem.system.restoring_force()(y) * (vs.restoring_force * edge);
    double largest = 0;
    for (std::size_t j = 0; j < vs.velocities.size(); ++j) {
      const double r = y + l(static_cast<int>(j)) - 0.3;
      largest = std::max(largest, std::abs(r) / e.weight(y, vs.velocities[j]));
    }
    EXPECT_LE(largest, outside) << y;
    EXPECT_GT(largest, 0.02 * outside) << y;
  }
}

}  // namespace
}  // namespace fpkcheck::backward
