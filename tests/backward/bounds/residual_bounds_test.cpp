#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "backward/bounds/residual_bounds.hpp"
#include "backward/generator/generator_at_collocation_points.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::backward {
namespace {

// An inaccurate certificate, whose residual is large and varies.
struct InaccurateCertificate {
  problem::Problem problem;
  ResidualWeightFunctionOfEnergy weight;
  numerics::SplineBasis displacement;
  ImpactSplineBasis velocity;
  GeneratorDisplacementFactorEnclosures displacement_factors;
  GeneratorVelocityFactorEnclosures velocity_factors;
  Eigen::MatrixXd coefficients;

  explicit InaccurateCertificate(const std::string& law, double max_displacement = 4,
                                 double max_speed = 5)
      : problem(problem::load_case(
            "case1", {"system.restitution=0.7", "impulse.law=" + law, "impulse.mean=0.05"})),
        weight(make_residual_weight(problem, 12)),
        displacement(numerics::graded_break_points(max_displacement, 5, 0.1, 1)),
        velocity(numerics::SplineBasis(numerics::graded_break_points(max_speed, 5, 0.1, 1)), 0.7),
        displacement_factors(numerics::call_with_upward_rounding(
            [&] { return enclose_displacement_factors(problem, displacement, {}); })),
        velocity_factors(numerics::call_with_upward_rounding(
            [&] { return enclose_velocity_factors(problem, velocity, {}); })),
        coefficients(displacement.size(), velocity.size()) {
    for (int a = 0; a < coefficients.rows(); ++a) {
      for (int b = 0; b < coefficients.cols(); ++b) {
        coefficients(a, b) = std::sin(0.6 * a) * std::cos(0.5 * b) + 0.02 * std::cos(3.0 * a * b);
      }
    }
  }
  ResidualBoundInputs inputs() const {
    return {problem, displacement, velocity, displacement_factors, velocity_factors, weight};
  }
  BoundCertificate certificate() const { return {coefficients, 0.3}; }
};

// Returns the smallest and the largest value of (f + L V - U)/tau over points inside the box, in
// rounded arithmetic.
std::pair<double, double> sample_residual_range(const InaccurateCertificate& e,
                                                const StationaryFunctional& f) {
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 24);
  const GeneratorVelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.velocity_factors, e.velocity, 24); });
  std::pair<double, double> range{0, 0};
  for (std::size_t i = 0; i < ys.displacements.size(); ++i) {
    const Eigen::MatrixXd local =
        ys.values_and_slopes[i] *
        e.coefficients.middleRows(ys.knot_spans[i], e.displacement.degree() + 1);
    const Eigen::VectorXd a = local.row(0), slope = local.row(1);
    const Eigen::VectorXd l =
        vs.impulse_and_damping * a + vs.transport * slope +
        e.problem.system.restoring_force()(ys.displacements[i]) * (vs.restoring_force * a);
    for (std::size_t j = 0; j < vs.velocities.size(); ++j) {
      const double r = (evaluate_integrand(f, e.problem, ys.displacements[i], vs.velocities[j]) +
                        l(static_cast<int>(j)) - 0.3) /
                       e.weight(ys.displacements[i], vs.velocities[j]);
      range = {std::min(range.first, r), std::max(range.second, r)};
    }
  }
  return range;
}

TEST(ResidualRange, ContainsAllSamplesAndIsNarrow) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    const InaccurateCertificate e(law);
    for (const StationaryFunctional& f :
         {StationaryFunctional(PowerMoment{StateVariable::y, 2}),
          StationaryFunctional(PowerMoment{StateVariable::ydot, 4})}) {
      const auto [least, largest] = sample_residual_range(e, f);
      const BackwardResidualRange range = numerics::call_with_upward_rounding([&] {
        return enclose_residual_range(e.inputs(), f, e.certificate(), {0, 0}, 0.02);
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
  const InaccurateCertificate e("gaussian");
  const StationaryFunctional f = PowerMoment{StateVariable::y, 2};
  const auto [least, largest] = sample_residual_range(e, f);
  const std::pair expected(10 * least, 10 * largest);
  const BackwardResidualRange range = numerics::call_with_upward_rounding([&] {
    return enclose_residual_range(e.inputs(), f, e.certificate(), {expected.first, expected.second},
                                  0.02);
  });
  EXPECT_LE(range.least, least);
  EXPECT_GE(range.largest, largest);
}

TEST(ResidualRange, IsUnboundedForNaN) {
  InaccurateCertificate e("gaussian");
  e.coefficients(2, 3) = std::nan("");
  const BackwardResidualRange range = numerics::call_with_upward_rounding([&] {
    return enclose_residual_range(e.inputs(), PowerMoment{StateVariable::y, 1}, e.certificate(),
                                  {0, 0}, 0.02);
  });
  EXPECT_FALSE(std::isfinite(range.largest - range.least));
}

TEST(OuterResidual, BoundsAllSamplesOutsideTheBox) {
  const InaccurateCertificate e("gaussian");
  const StationaryFunctional f = PowerMoment{StateVariable::ydot, 4};
  const double bound = numerics::call_with_upward_rounding(
      [&] { return outer_residual_bound(e.inputs(), f, e.certificate()); });
  // For y > y_end V has the coefficients of the last row.
  const GeneratorVelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.velocity_factors, e.velocity, 5); });
  const Eigen::VectorXd last = e.coefficients.bottomRows<1>().transpose();
  const Eigen::VectorXd jump = vs.impulse_and_damping * last, force = vs.restoring_force * last;
  for (const double y : {4.0001, 4.5, 8.0, 20.0}) {
    for (std::size_t j = 0; j < vs.velocities.size(); ++j) {
      const int row = static_cast<int>(j);
      const double r = std::pow(vs.velocities[j], 4) + jump(row) +
                       e.problem.system.restoring_force()(y) * force(row) - 0.3;
      EXPECT_LE(std::abs(r) / e.weight(y, vs.velocities[j]), bound) << y << " " << vs.velocities[j];
    }
  }
  // Past the largest speeds L V consists of v V_y and the jump term.
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 5);
  for (std::size_t i = 0; i < ys.displacements.size(); ++i) {
    for (const double v : {-5.001, -7.0, -30.0, 3.501, 5.0, 30.0}) {
      const Eigen::VectorXd edge =
          v < 0 ? e.coefficients.leftCols<1>() : e.coefficients.rightCols<1>();
      const double slope = ys.values_and_slopes[i].row(1).dot(edge.segment(ys.knot_spans[i], 7));
      EXPECT_LE(std::abs(std::pow(v, 4) + v * slope - 0.3) / e.weight(ys.displacements[i], v),
                bound);
    }
  }
}

TEST(OuterResidual, DependsOnSlopesInVPastTheLargestDisplacement) {
  // With a small y_end, and V a steep function of v alone, f and the jump term are small.
  InaccurateCertificate e("gaussian", 4, 12);
  for (int b = 0; b < e.coefficients.cols(); ++b)
    e.coefficients.col(b).setConstant(1e3 * std::sin(b));
  const StationaryFunctional f = PowerMoment{StateVariable::y, 1};
  const double bound = numerics::call_with_upward_rounding(
      [&] { return outer_residual_bound(e.inputs(), f, e.certificate()); });
  const GeneratorVelocityFactorSamples vs = numerics::call_with_upward_rounding(
      [&] { return sample_velocity_factors(e.velocity_factors, e.velocity, 9); });
  const Eigen::VectorXd last = e.coefficients.bottomRows<1>().transpose();
  const Eigen::VectorXd l =
      vs.impulse_and_damping * last +
      e.problem.system.restoring_force()(4.0001) * (vs.restoring_force * last);
  double largest = 0;
  for (std::size_t j = 0; j < vs.velocities.size(); ++j) {
    largest = std::max(largest,
                       std::abs(l(static_cast<int>(j)) + 3.7) / e.weight(4.0001, vs.velocities[j]));
  }
  EXPECT_LE(largest, bound);
  EXPECT_GT(largest, 0.02 * bound);
}

TEST(OuterResidual, DependsOnSlopesInYPastTheLargestSpeeds) {
  // With a small u_end, and V a steep function of y alone, L V = v V_y.
  InaccurateCertificate e("gaussian", 9, 7);
  for (int a = 0; a < e.coefficients.rows(); ++a)
    e.coefficients.row(a).setConstant(1e3 * std::sin(a));
  const StationaryFunctional f = PowerMoment{StateVariable::y, 1};
  const double bound = numerics::call_with_upward_rounding(
      [&] { return outer_residual_bound(e.inputs(), f, e.certificate()); });
  const DisplacementSplineSamples ys = sample_displacement_splines(e.displacement, 9);
  double largest = 0;
  for (std::size_t i = 0; i < ys.displacements.size(); ++i) {
    const Eigen::VectorXd c = e.coefficients.col(0).segment(ys.knot_spans[i], 7);
    for (const double v : {-7.0001, 4.9001}) {
      const double r = ys.displacements[i] + v * ys.values_and_slopes[i].row(1).dot(c) - 0.3;
      largest = std::max(largest, std::abs(r) / e.weight(ys.displacements[i], v));
    }
  }
  EXPECT_LE(largest, bound);
  EXPECT_GT(largest, 0.02 * bound);
}

}  // namespace
}  // namespace fpkcheck::backward
