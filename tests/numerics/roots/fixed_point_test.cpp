#include "numerics/roots/fixed_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace fpkcheck::numerics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

FixedPointOptions to_tolerance(double tolerance, int evaluations = 60) {
  return {.size = [](const VectorXd& change) { return change.norm(); },
          .tolerance = tolerance,
          .max_evaluations = evaluations};
}

// The affine map x -> x_f + A (x - x_f) with slow modes of the rates 0.99 and 0.98 exp(+-i), and
// fast modes of the rate 0.01.
VectorXd fixed_point_of_map() { return VectorXd::LinSpaced(30, -1, 2); }
VectorXd affine_map(const VectorXd& x) {
  MatrixXd a = 0.01 * MatrixXd::Identity(30, 30);
  a(0, 0) = 0.99;
  a.block<2, 2>(1, 1) << 0.98 * std::cos(1), -0.98 * std::sin(1), 0.98 * std::sin(1),
      0.98 * std::cos(1);
  return fixed_point_of_map() + a * (x - fixed_point_of_map());
}

// Without the extrapolation the error after 20 evaluations is 0.8 of the first.
TEST(FixedPoint, OfAnAffineMapIsFoundInFewEvaluations) {
  const FixedPointResult found =
      solve_fixed_point([](const VectorXd& x) { return std::optional(affine_map(x)); },
                        VectorXd::Zero(30), to_tolerance(1e-9));
  EXPECT_TRUE(found.converged);
  EXPECT_LE(found.evaluations, 20);
  EXPECT_LT((found.x - fixed_point_of_map()).norm(), 1e-6);
}

TEST(FixedPoint, OfANonlinearMap) {
  const auto cosine = [](const VectorXd& x) {
    return std::optional<VectorXd>(x.array().cos().matrix());
  };
  const FixedPointResult found = solve_fixed_point(cosine, VectorXd::Zero(2), to_tolerance(1e-12));
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.x[1], 0.7390851332151607, 1e-11);
}

TEST(FixedPoint, StaysInTheDomainOfTheMap) {
  // The map accepts its own images alone, hence no extrapolated value.
  VectorXd last = VectorXd::Constant(1, 16);
  const auto root = [&](const VectorXd& x) -> std::optional<VectorXd> {
    if (x != last) return std::nullopt;
    last = x.array().sqrt().matrix();
    return last;
  };
  const FixedPointResult found = solve_fixed_point(root, last, to_tolerance(1e-6));
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.x[0], 1, 2e-6);
}

TEST(FixedPoint, IsNotConvergedAtTheLimitOfEvaluations) {
  const FixedPointResult found =
      solve_fixed_point([](const VectorXd& x) { return std::optional(affine_map(x)); },
                        VectorXd::Zero(30), to_tolerance(1e-9, 4));
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.evaluations, 4);
  EXPECT_GT(found.change, 1e-3);
}

}  // namespace
}  // namespace fpkcheck::numerics
