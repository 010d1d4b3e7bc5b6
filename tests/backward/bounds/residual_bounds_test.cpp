#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "backward/bounds/residual_bounds.hpp"
#include "backward/generator/collocation.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::backward {
namespace {

// An inaccurate certificate: the residual is large and varies.
struct Example {
  problem::Problem problem;
  ResidualWeight tau;
  numerics::SplineBasis displacement;
  ImpactBasis velocity;
  DisplacementFactorEnclosures y;
  VelocityFactorEnclosures v;
  Eigen::MatrixXd coefficients;

  explicit Example(const std::string& law, double y_end = 4, double u_end = 5)
      : problem(problem::load_case(
            "case1", {"system.restitution=0.7", "impulse.law=" + law, "impulse.mean=0.05"})),
        tau(residual_weight(problem, 12)),
        displacement(numerics::graded_breaks(y_end, 5, 0.1, 1)),
        velocity(numerics::SplineBasis(numerics::graded_breaks(u_end, 5, 0.1, 1)), 0.7),
        y(numerics::call_with_upward_rounding(
            [&] { return enclose_displacement_factors(problem, displacement, {}); })),
        v(numerics::call_with_upward_rounding(
            [&] { return enclose_velocity_factors(problem, velocity, {}); })),
        coefficients(displacement.size(), velocity.size()) {
    for (int a = 0; a < coefficients.rows(); ++a) {
      for (int b = 0; b < coefficients.cols(); ++b) {
        coefficients(a, b) = std::sin(0.6 * a) * std::cos(0.5 * b) + 0.02 * std::cos(3.0 * a * b);
      }
    }
  }
  CertificateCheckInputs context() const { return {problem, displacement, velocity, y, v, tau}; }
  Certificate certificate() const { return {coefficients, 0.3}; }
};

// Smallest and largest (f + L V - U)/tau over points inside the box, by the rounded operators.
std::pair<double, double> sampled_range(const Example& e, const Functional& f) {
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 24);
  const VelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.v, e.velocity, 24); });
  std::pair<double, double> range{0, 0};
  for (std::size_t i = 0; i < ys.y.size(); ++i) {
    const Eigen::MatrixXd local =
        ys.values[i] * e.coefficients.middleRows(ys.span[i], e.displacement.degree() + 1);
    const Eigen::VectorXd a = local.row(0), slope = local.row(1);
    const Eigen::VectorXd l = vs.jump * a + vs.drift * slope +
                              e.problem.system.restoring_force()(ys.y[i]) * (vs.force * a);
    for (std::size_t j = 0; j < vs.v.size(); ++j) {
      const double r = (integrand(f, e.problem, ys.y[i], vs.v[j]) + l(static_cast<int>(j)) - 0.3) /
                       e.tau(ys.y[i], vs.v[j]);
      range = {std::min(range.first, r), std::max(range.second, r)};
    }
  }
  return range;
}

TEST(ResidualRange, ContainsAllSamplesAndIsNarrow) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    const Example e(law);
    for (const Functional& f : {Functional(PowerMoment{Axis::displacement, 2}),
                                Functional(PowerMoment{Axis::velocity, 4})}) {
      const auto [least, largest] = sampled_range(e, f);
      const ResidualRange range = numerics::call_with_upward_rounding([&] {
        return residual_range(e.context(), f, e.certificate(), {0, 0}, 0.02);
      });
      EXPECT_TRUE(range.is_converged) << law;
      EXPECT_LE(range.least, least) << law;
      EXPECT_GE(range.largest, largest) << law;
      EXPECT_GT(range.least, 1.1 * least) << law;
      EXPECT_LT(range.largest, 1.1 * largest) << law;
    }
  }
}

TEST(ResidualRange, DoesNotDependOnExpectedValues) {
  const Example e("gaussian");
  const Functional f = PowerMoment{Axis::displacement, 2};
  const auto [least, largest] = sampled_range(e, f);
  const std::pair expected(10 * least, 10 * largest);
  const ResidualRange range = numerics::call_with_upward_rounding([&] {
    return residual_range(e.context(), f, e.certificate(), {expected.first, expected.second}, 0.02);
  });
  EXPECT_LE(range.least, least);
  EXPECT_GE(range.largest, largest);
}

TEST(ResidualRange, IsUnboundedForNaN) {
  Example e("gaussian");
  e.coefficients(2, 3) = std::nan("");
  const ResidualRange range = numerics::call_with_upward_rounding([&] {
    return residual_range(e.context(), PowerMoment{Axis::displacement, 1}, e.certificate(), {0, 0},
                          0.02);
  });
  EXPECT_FALSE(std::isfinite(range.largest - range.least));
}

TEST(OuterResidual, BoundsAllSamplesOutsideTheBox) {
  const Example e("gaussian");
  const Functional f = PowerMoment{Axis::velocity, 4};
  const double bound = numerics::call_with_upward_rounding(
      [&] { return outer_residual_bound(e.context(), f, e.certificate()); });
  // For y > y_end V has the coefficients of the last row.
  const VelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.v, e.velocity, 5); });
  const Eigen::VectorXd last = e.coefficients.bottomRows<1>().transpose();
  const Eigen::VectorXd jump = vs.jump * last, force = vs.force * last;
  for (const double y : {4.0001, 4.5, 8.0, 20.0}) {
    for (std::size_t j = 0; j < vs.v.size(); ++j) {
      const int row = static_cast<int>(j);
      const double r = std::pow(vs.v[j], 4) + jump(row) +
                       e.problem.system.restoring_force()(y) * force(row) - 0.3;
      EXPECT_LE(std::abs(r) / e.tau(y, vs.v[j]), bound) << y << " " << vs.v[j];
    }
  }
  // Past the largest speeds L V consists of v V_y and the jump term.
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 5);
  for (std::size_t i = 0; i < ys.y.size(); ++i) {
    for (const double v : {-5.001, -7.0, -30.0, 3.501, 5.0, 30.0}) {
      const Eigen::VectorXd edge =
          v < 0 ? e.coefficients.leftCols<1>() : e.coefficients.rightCols<1>();
      const double slope = ys.values[i].row(1).dot(edge.segment(ys.span[i], 7));
      EXPECT_LE(std::abs(std::pow(v, 4) + v * slope - 0.3) / e.tau(ys.y[i], v), bound);
    }
  }
}

TEST(OuterResidual, DependsOnSlopesInVPastTheLargestDisplacement) {
  // With a small y_end, and V a steep function of v alone, f and the jump term are small.
  Example e("gaussian", 4, 12);
  for (int b = 0; b < e.coefficients.cols(); ++b)
    e.coefficients.col(b).setConstant(1e3 * std::sin(b));
  const Functional f = PowerMoment{Axis::displacement, 1};
  const double bound = numerics::call_with_upward_rounding(
      [&] { return outer_residual_bound(e.context(), f, e.certificate()); });
  const VelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.v, e.velocity, 9); });
  const Eigen::VectorXd last = e.coefficients.bottomRows<1>().transpose();
  const Eigen::VectorXd l =
      vs.jump * last + e.problem.system.restoring_force()(4.0001) * (vs.force * last);
  double largest = 0;
  for (std::size_t j = 0; j < vs.v.size(); ++j) {
    largest = std::max(largest, std::abs(l(static_cast<int>(j)) + 3.7) / e.tau(4.0001, vs.v[j]));
  }
  EXPECT_LE(largest, bound);
  EXPECT_GT(largest, 0.02 * bound);
}

TEST(OuterResidual, DependsOnSlopesInYPastTheLargestSpeeds) {
  // With a small u_end, and V a steep function of y alone, L V = v V_y.
  Example e("gaussian", 9, 7);
  for (int a = 0; a < e.coefficients.rows(); ++a)
    e.coefficients.row(a).setConstant(1e3 * std::sin(a));
  const Functional f = PowerMoment{Axis::displacement, 1};
  const double bound = numerics::call_with_upward_rounding(
      [&] { return outer_residual_bound(e.context(), f, e.certificate()); });
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 9);
  double largest = 0;
  for (std::size_t i = 0; i < ys.y.size(); ++i) {
    const Eigen::VectorXd c = e.coefficients.col(0).segment(ys.span[i], 7);
    for (const double v : {-7.0001, 4.9001}) {
      const double r = ys.y[i] + v * ys.values[i].row(1).dot(c) - 0.3;
      largest = std::max(largest, std::abs(r) / e.tau(ys.y[i], v));
    }
  }
  EXPECT_LE(largest, bound);
  EXPECT_GT(largest, 0.02 * bound);
}

}  // namespace
}  // namespace fpkcheck::backward
