#include "problem/parameter_derivative.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::problem {
namespace {

// Returns the difference quotient of a function of the problem.
template <class Function>
double quotient(const ParameterDifferenceQuotient& derivative, const Function& f) {
  double sum = 0;
  for (const auto& [weight, problem] : derivative.terms) sum += weight * f(problem);
  return sum;
}

TEST(ParameterDerivative, IsOfSecondOrderAlsoAtAnEndOfTheRange) {
  for (const double restitution : {0.9, 1.0}) {
    const Problem p = tests::make_problem({.restitution = restitution});
    const auto derivative = parameter_difference_quotient(p, "system.restitution", 1e-3);
    EXPECT_EQ(derivative.value, restitution);
    EXPECT_EQ(derivative.terms.size(), restitution < 1 ? 2u : 3u);
    const auto r = [](const Problem& one) { return *one.system.coefficients().restitution; };
    EXPECT_NEAR(quotient(derivative, [&](const Problem& one) { return r(one); }), 1, 1e-9);
    EXPECT_NEAR(quotient(derivative, [&](const Problem& one) { return r(one) * r(one); }),
                2 * restitution, 1e-9);
    EXPECT_NEAR(quotient(derivative, [](const Problem&) { return 1.0; }), 0, 1e-9);
  }
}

TEST(ParameterDerivative, ToTheRateKeepsTheIntensity) {
  const auto derivative = parameter_difference_quotient(tests::paper_case(1), "impulse.rate", 1e-3);
  EXPECT_NEAR(quotient(derivative, [](const Problem& p) { return p.impulses.intensity(); }), 0,
              1e-10);
  // E[Y^2] = intensity / rate
  EXPECT_NEAR(
      quotient(derivative, [](const Problem& p) { return p.impulses.amplitude_law().moment(2); }),
      -0.1, 1e-6);
}

TEST(ParameterDerivative, HasAllNumbersOfTheCaseButPositionsOfWalls) {
  EXPECT_EQ(differentiable_parameters(tests::paper_case(1)),
            (std::vector<std::string>{"system.damping", "system.stiffness", "system.cubic",
                                      "system.restitution", "impulse.rate", "impulse.intensity"}));
  const Problem gap =
      tests::with_impulses(System({.damping = 0.1, .stiffness = 1},
                                  WallParameters{.left = -0.5, .left_restitution = 0.9}),
                           tests::gaussian_impulses(1, 0.1));
  const auto keys = differentiable_parameters(gap);
  EXPECT_EQ(std::ranges::count(keys, "wall.left"), 0);
  EXPECT_EQ(std::ranges::count(keys, "wall.left_restitution"), 1);
  EXPECT_THROW(parameter_difference_quotient(gap, "wall.left", 1e-3), InputError);
  EXPECT_THROW(parameter_difference_quotient(gap, "system.nothing", 1e-3), InputError);
}

}  // namespace
}  // namespace fpkcheck::problem
