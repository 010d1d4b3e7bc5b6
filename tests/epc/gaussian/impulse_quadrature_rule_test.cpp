#include "epc/gaussian/impulse_quadrature_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "laws.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using problem::ImpulseLaw;

double mean_of(const QuadratureRule& rule, const std::function<double(double)>& g) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * g(rule.nodes[i]);
  return sum;
}

void expect_moments(const QuadratureRule& rule, const ImpulseLaw& law, double tolerance) {
  for (int order = 0; order < problem::kMomentCount; ++order) {
    const double moment = mean_of(rule, [&](double y) { return std::pow(y, order); });
    EXPECT_NEAR(moment / law.moment(order), 1, tolerance) << law.name() << ' ' << order;
  }
}

void expect_moment_generating_function(const QuadratureRule& rule, const ImpulseLaw& law,
                                       double tolerance) {
  for (const double u : {-1.0, 1.5}) {
    const double mean = mean_of(rule, [&](double y) { return std::exp(u * y); });
    EXPECT_NEAR(mean / law.moment_generating_function(u), 1, tolerance) << law.name() << ' ' << u;
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
  EXPECT_EQ(rule.weights, (std::vector<double>{0.5, 0.5}));
  EXPECT_NEAR(rule.nodes[1], 1.0, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
