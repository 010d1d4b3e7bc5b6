#include "backward/bounds/bounded_expectation.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include "base/input_error.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::backward {
namespace {

TEST(Functional, IntegrandsMatchTheNames) {
  const problem::Problem problem = problem::load_case("case1");
  const std::vector<StationaryFunctional> all = default_functionals();
  const std::vector<std::pair<const char*, double>> expected{
      {"E[y]", 0.5},      {"E[y^2]", 0.25},  {"E[y'^2]", 4.0},
      {"E[y^4]", 0.0625}, {"E[y'^4]", 16.0}, {"w1", 0.5 + 0.1 * 0.125}};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(functional_name(all[i]), expected[i].first);
    EXPECT_NEAR(evaluate_integrand(all[i], problem, 0.5, -2), expected[i].second, 1e-15);
  }
}

TEST(SmoothBin, HasUnitIntegralWithItsFactor) {
  const problem::Problem problem = problem::load_case("case1");
  const StationaryFunctional bin = SmoothBin{StateVariable::ydot, {-0.7, -0.4, 0.1, 0.2, 0.9}};
  double integral = 0;
  const std::vector<double> knots = integrand_breakpoints(bin);
  for (int i = 0; i < 4; ++i) {
    integral += boost::math::quadrature::gauss<double, 7>::integrate(
        [&](double v) { return evaluate_integrand(bin, problem, 0.3, v); }, knots[i], knots[i + 1]);
  }
  EXPECT_NEAR(integral * 4 / (0.9 + 0.7), 1, 1e-14);
  EXPECT_EQ(evaluate_integrand(bin, problem, 0.3, 0.95), 0);
}

TEST(Functional, RejectsInvalidPowersAndKnots) {
  EXPECT_THROW(require_valid_functional(PowerMoment{StateVariable::ydot, 5}), InputError);
  EXPECT_THROW(require_valid_functional(SmoothBin{StateVariable::ydot, {0, 1, 1, 2, 3}}),
               InputError);
  EXPECT_THROW(
      require_valid_functional(SmoothBin::with_equidistant_knots(StateVariable::y, 0.1, 0.1)),
      InputError);
  EXPECT_NO_THROW(
      require_valid_functional(SmoothBin::with_equidistant_knots(StateVariable::ydot, 0.1, 0.1)));
}

}  // namespace
}  // namespace fpkcheck::backward
