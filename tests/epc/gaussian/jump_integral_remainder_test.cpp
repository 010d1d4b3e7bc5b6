#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "epc/gaussian/jump_integral_remainder.hpp"
#include "epc/gaussian/projected_equations.hpp"
#include "epc/selection_policy.hpp"
#include "exact/law_transforms.hpp"
#include "laws.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "paper_cases.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

const std::vector<std::string> kLaws{"gaussian", "laplace", "two_point", "uniform"};

GaussianWeightedBasis make_basis(const problem::Problem& p, int order,
                                 MonomialSet set = MonomialSet::point_symmetric) {
  return GaussianWeightedBasis(order, set, gaussian_weight_deviations(p));
}

// The expectation has a closed form for a quadratic Q: for Q = -a x2^2 and a law with two atoms,
// E[exp(Q(x2 - Y) - Q(x2))] is the mean over the atoms of exp(2 a x2 Y - a Y^2).
TEST(JumpIntegralRemainder, IsTheJumpIntegralLessItsSeries) {
  const problem::Problem p =
      tests::make_problem({.rate = 0.7, .intensity = 0.3, .mean = 0.2, .law = "two_point"});
  const GaussianWeightedBasis basis = make_basis(p, 2);
  const double a = 0.8, b = 0.35, radius = 3;  // Q = -a x2^2 + b x1 x2 - x1^2 / 2
  const Eigen::VectorXd coefficients =
      basis.scaled_coefficients({{2, 0, -0.5}, {1, 1, b}, {0, 2, -a}});
  const auto [s1, s2] = basis.weight_standard_deviations();
  const auto& impulses = p.impulses;
  const auto remainder = [&](double x1, double x2) {
    const double side = x1 > 0 ? 1 : -1;
    const double slope = b * x1 - 2 * a * x2, curvature = -2 * a;
    double sum = -1;
    for (const auto& [y, probability] : impulses.amplitude_law().amplitude_atoms()) {
      sum += probability * std::exp(-side * y * slope + y * y / 2 * curvature);
    }
    // The terms of the series are exp(-Q) times the derivatives of exp(Q).
    const double first = slope, second = slope * slope + curvature,
                 third = slope * slope * slope + 3 * slope * curvature,
                 fourth =
                     std::pow(slope, 4) + 6 * slope * slope * curvature + 3 * curvature * curvature;
    return impulses.arrival_rate() * sum + side * impulses.rate_times_moment(1) * first -
           impulses.rate_times_moment(2) / 2 * second +
           side * impulses.rate_times_moment(3) / 6 * third -
           impulses.rate_times_moment(4) / 24 * fourth;
  };
  Eigen::Vector3d expected = Eigen::Vector3d::Zero();
  for (const auto& [rho, rho_weight] : numerics::composite_gauss_points(0, radius, 6)) {
    for (const double side : {0.0, std::numbers::pi}) {
      for (const auto& [angle, width] : numerics::composite_gauss_points(
               side - std::numbers::pi / 2, side + std::numbers::pi / 2, 6)) {
        const double x1 = s1 * rho * std::cos(angle), x2 = s2 * rho * std::sin(angle);
        const double weight =
            rho_weight * width * rho * std::exp(-rho * rho / 2) / (2 * std::numbers::pi);
        for (int s = 0; s < 3; ++s) {
          expected[s] += weight * remainder(x1, x2) *
                         basis.basis_values(Eigen::VectorXd::Constant(1, x1),
                                            Eigen::VectorXd::Constant(1, x2))(0, s);
        }
      }
    }
  }
  const Eigen::VectorXd found =
      JumpIntegralRemainder(basis, impulses, radius).projected_remainder(coefficients);
  EXPECT_GT(expected.norm(), 1e-3);
  EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm());
}

TEST(JumpIntegralRemainder, OddProjectionsOfAPointSymmetricPolynomialVanish) {
  const problem::Problem p = tests::make_problem({.mean = 0.1, .law = "laplace"});
  const GaussianWeightedBasis half = make_basis(p, 4),
                              whole = make_basis(p, 4, MonomialSet::general);
  const auto [s1, s2] = half.weight_standard_deviations();
  const std::vector<ExponentMonomial> q{
      {2, 0, -0.5 / (s1 * s1)}, {0, 2, -0.5 / (s2 * s2)}, {1, 1, 0.1}, {0, 4, -0.01}};
  const Eigen::VectorXd even =
      JumpIntegralRemainder(half, p.impulses).projected_remainder(half.scaled_coefficients(q));
  const Eigen::VectorXd all =
      JumpIntegralRemainder(whole, p.impulses).projected_remainder(whole.scaled_coefficients(q));
  ASSERT_EQ(all.size(), 14);
  EXPECT_LT(all.head(2).norm(), 1e-12);                         // degree 1
  EXPECT_LT((all.segment(2, 3) - even.head(3)).norm(), 1e-12);  // degree 2
  EXPECT_LT(all.segment(5, 4).norm(), 1e-12);
  EXPECT_LT((all.tail(5) - even.tail(5)).norm(), 1e-12);
}

TEST(JumpIntegralRemainder, JacobianIsTheDerivativeOfTheProjection) {
  for (const std::string& law : kLaws) {
    const problem::Problem p = tests::make_problem({.mean = 0.1, .law = law});
    const GaussianWeightedBasis basis = make_basis(p, 6);
    const ProjectedEquations projection(basis, p.impulses);
    const DensityEquationCoefficients f = residual_coefficients(p, DensityEquation::kf);
    const auto [s1, s2] = basis.weight_standard_deviations();
    Eigen::VectorXd a = basis.scaled_coefficients(
        {{2, 0, -0.5 / (s1 * s1)}, {0, 2, -0.5 / (s2 * s2)}, {1, 3, 0.02}, {0, 6, -0.001}});
    const Eigen::MatrixXd jacobian = projection.jacobian(f, a);
    const double h = 2e-5;
    for (Eigen::Index k = 0; k < a.size(); ++k) {
      const Eigen::VectorXd e = Eigen::VectorXd::Unit(a.size(), k) * h;
      const auto difference = [&](double m) -> Eigen::VectorXd {
        return (projection.residual(f, a + m * e) - projection.residual(f, a - m * e)) /
               (2 * m * h);
      };
      const Eigen::VectorXd expected = (4 * difference(1) - difference(2)) / 3;
      EXPECT_LT((jacobian.col(k) - expected).norm(), 1e-7 * jacobian.norm()) << law << ' ' << k;
    }
  }
}

// Frequent, small impulses tend to white noise: the remainder is of sixth order in Y.
TEST(JumpIntegralRemainder, IsOfSixthOrderInTheImpulses) {
  const auto size = [](double rate) {
    const problem::Problem p = tests::make_problem({.rate = rate});
    const GaussianWeightedBasis basis = make_basis(p, 4);
    const auto [s1, s2] = basis.weight_standard_deviations();
    return JumpIntegralRemainder(basis, p.impulses)
        .projected_remainder(
            basis.scaled_coefficients({{2, 0, -0.5 / (s1 * s1)}, {0, 2, -0.3 / (s2 * s2)}}))
        .norm();
  };
  // At constant intensity lambda E[Y^6] is proportional to rate^-2.
  EXPECT_NEAR(size(2000) / size(4000), 4, 0.1);
}

using numerics::QuadratureRule;
using problem::ImpulseLaw;

double mean_by_rule(const QuadratureRule& rule, const std::function<double(double)>& g) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) sum += rule.weights[i] * g(rule.points[i]);
  return sum;
}

void expect_moments(const QuadratureRule& rule, const ImpulseLaw& law, double tolerance) {
  for (int order = 0; order < problem::kMomentCount; ++order) {
    const double moment = mean_by_rule(rule, [&](double y) { return std::pow(y, order); });
    EXPECT_NEAR(moment / law.moment(order), 1, tolerance) << law.name() << ' ' << order;
  }
}

void expect_moment_generating_function(const QuadratureRule& rule, const ImpulseLaw& law,
                                       double tolerance) {
  for (const double u : {-1.0, 1.5}) {
    const double mean = mean_by_rule(rule, [&](double y) { return std::exp(u * y); });
    EXPECT_NEAR(mean / exact::moment_generating_function(law, u), 1, tolerance)
        << law.name() << ' ' << u;
  }
}

TEST(ImpulseRule, HasTheMomentsOfEveryLaw) {
  for (const std::string& name : tests::law_names_without_table()) {
    const auto law = ImpulseLaw::from_name(name, 0.3, 0.7);
    expect_moments(impulse_quadrature_rule(law, 8), law, 1e-12);
  }
}

TEST(ImpulseRule, HasTheMomentGeneratingFunctionOfEveryLaw) {
  for (const std::string& name : tests::law_names_without_table()) {
    const auto law = ImpulseLaw::from_name(name, -0.2, 0.4);
    expect_moment_generating_function(impulse_quadrature_rule(law, 20), law, 1e-7);
  }
}

// The quadrature rule of a law without a Gauss rule uses the atoms and the density of the law. The
// probability outside the pieces of laplace is exp(-42); the missing part of E[Y^6] is 42^6/6!
// times larger.
TEST(PiecewiseImpulseRule, HasTheMomentsOfEveryLaw) {
  for (const std::string& name : tests::law_names_without_table()) {
    const auto law = ImpulseLaw::from_name(name, 0.3, 0.7);
    expect_moments(piecewise_impulse_quadrature_rule(law), law, 2e-11);
  }
}

TEST(PiecewiseImpulseRule, HasTheMomentGeneratingFunctionOfEveryLaw) {
  for (const std::string& name : tests::law_names_without_table()) {
    const auto law = ImpulseLaw::from_name(name, -0.2, 0.4);
    // The probability beyond the pieces of exponential is exp(-46). The missing part of the
    // generating function is exp(-(1 - 1.5 0.4) 46) = 1e-8.
    expect_moment_generating_function(piecewise_impulse_quadrature_rule(law), law, 2e-8);
  }
}

TEST(PiecewiseImpulseRule, OfALawWithoutADensityIsItsAtoms) {
  const QuadratureRule rule =
      piecewise_impulse_quadrature_rule(ImpulseLaw::from_name("two_point", 0.3, 0.7));
  EXPECT_EQ(rule.weights, Eigen::Vector2d(0.5, 0.5));
  EXPECT_NEAR(rule.points[1], 1.0, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
