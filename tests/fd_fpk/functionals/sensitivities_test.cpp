#include "fd_fpk/functionals/sensitivities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fd_fpk/solve.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::System;
using transform::ExpectationDerivatives;
using transform::Sensitivities;
using transform::Status;

Sensitivities sensitivities(const problem::Problem& p, const std::vector<std::string>& keys,
                            const Options& options = {}) {
  std::vector<problem::ParameterDerivative> parameters;
  for (const auto& key : keys) parameters.push_back(problem::parameter_derivative(p, key, 1e-4));
  return solve_sensitivities(p, options, parameters);
}

const ExpectationDerivatives& of(const Sensitivities& s, const std::string& expectation) {
  return *std::ranges::find(s.expectations, expectation, &ExpectationDerivatives::expectation);
}

// E[y^2] = I / (2 c k), E[y'^2] = I / (2 c) with the intensity I of the impulses.
TEST(Sensitivities, AreExactForTheSecondMomentsOfTheLinearOscillator) {
  const double c = 0.3, k = 1.44, intensity = 0.1;
  const auto p = tests::with_impulses(System({.damping = c, .stiffness = k}, {.none = true}),
                                      tests::gaussian_impulses(1, intensity));
  const Sensitivities s =
      sensitivities(p, {"system.damping", "system.stiffness", "impulse.intensity", "impulse.rate"});
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const double y2 = intensity / (2 * c * k), v2 = intensity / (2 * c);
  const double exact_y2[] = {-y2 / c, -y2 / k, y2 / intensity, 0};
  const double exact_v2[] = {-v2 / c, 0, v2 / intensity, 0};
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_NEAR(of(s, "E[y^2]").derivatives[n], exact_y2[n], 1e-5 * y2 / c) << s.parameters[n];
    EXPECT_NEAR(of(s, "E[y'^2]").derivatives[n], exact_v2[n], 1e-5 * v2 / c) << s.parameters[n];
  }
  // E[y^4] = 3 E[y^2]^2 + lambda E[Y^4] int h^4 dt, and E[Y^4] = 3 (I/lambda)^2: at fixed intensity
  // the second term is inversely proportional to the rate.
  EXPECT_LT(of(s, "E[y^4]").derivatives[3], 0);
}

// With the scales of length and time a moment is a function of three parameters; the elasticities e
// then satisfy two identities for E[y^q] and for E[y'^q].
TEST(Sensitivities, SatisfyTheIdentitiesOfTheScalesOfLengthAndTime) {
  const auto p = tests::make_problem({.damping = 0.2, .restitution = 0.9});
  const Sensitivities s = sensitivities(p, {"system.damping", "system.stiffness", "system.cubic",
                                            "impulse.rate", "impulse.intensity"});
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const struct {
    const char* expectation;
    double power;
    bool of_velocity;
  } moments[] = {{"E[y^2]", 2, false}, {"E[y^4]", 4, false}, {"E[y'^2]", 2, true}};
  for (const auto& [expectation, power, of_velocity] : moments) {
    const auto& one = of(s, expectation);
    const auto e = [&](std::size_t k) {
      return one.derivatives[k] * s.parameter_values[k] / one.value;
    };
    // The identities hold up to the errors of the finest grid.
    double errors = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      errors += 3 * one.errors[k] * s.parameter_values[k] / one.value;
    }
    EXPECT_LT(errors, 1e-3);
    EXPECT_NEAR(e(4), power / 2 + e(2), errors) << expectation;
    EXPECT_NEAR(e(0) + 2 * e(1) + 2 * e(2) + e(3) + 3 * e(4), of_velocity ? power : 0, errors)
        << expectation;
  }
}

TEST(Sensitivities, ToTheRestitutionAreThoseOfDifferencesOnTheSameGrid) {
  const Options grid{.stepper = StationarySolver::direct,
                     .nx = 40,
                     .nv = 88,
                     .x1_max = 4,
                     .x2_max = 4.5,
                     .error_estimate = false};
  const auto moment = [&](double restitution) {
    return solve(tests::make_problem({.restitution = restitution}), grid).solution.moments.y2;
  };
  constexpr double kStep = 0.01;
  const auto difference = [&](double h) { return (moment(0.9 + h) - moment(0.9 - h)) / (2 * h); };
  // Richardson extrapolation of the differences
  const double expected = (4 * difference(kStep) - difference(2 * kStep)) / 3;
  const Sensitivities s =
      sensitivities(tests::make_problem({.restitution = 0.9}), {"system.restitution"});
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  EXPECT_NEAR(of(s, "E[y^2]").derivatives[0], expected, 1e-3 * expected);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
