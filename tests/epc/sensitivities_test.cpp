#include "epc/sensitivities.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_cases.hpp"

namespace fpkcheck::epc {
namespace {

using transform::MomentSensitivities;
using transform::Status;

std::vector<problem::ParameterDifferenceQuotient> parameter_derivatives(
    const problem::Problem& problem, const std::vector<std::string>& keys) {
  std::vector<problem::ParameterDifferenceQuotient> all;
  for (const std::string& key : keys) {
    all.push_back(problem::parameter_difference_quotient(problem, key, 1e-3));
  }
  return all;
}

// E[y^2] = I / (2 c k), E[y'^2] = I / (2 c) and E[y^4] = 3 E[y^2]^2 at an elastic wall at the
// equilibrium under white noise of the intensity I.
TEST(ClosureSensitivities, AreExactForALinearOscillator) {
  const auto problem =
      tests::make_problem({.damping = 0.2, .stiffness = 1.5, .cubic = 0, .restitution = 1});
  const ClosureOptions options{
      .order = 4, .formulation = Formulation::moment, .equation = DensityEquation::white};
  const MomentSensitivities s = solve_sensitivities(
      problem, options,
      parameter_derivatives(problem, {"system.damping", "system.stiffness", "impulse.intensity"}));
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const double c = 0.2, k = 1.5, i = 0.1, y2 = i / (2 * c * k), v2 = i / (2 * c);
  // The quotients with steps of 1e-3 have relative errors of 1e-6 to 4e-6.
  const double exact_y2[] = {-y2 / c, -y2 / k, y2 / i};
  const double exact_v2[] = {-v2 / c, 0, v2 / i};
  ASSERT_EQ(s.expectations.at(1).expectation, "E[y^2]");
  ASSERT_EQ(s.expectations.at(3).expectation, "E[y'^2]");
  for (std::size_t n = 0; n < 3; ++n) {
    SCOPED_TRACE(s.parameters[n]);
    EXPECT_NEAR(s.expectations[1].derivatives[n], exact_y2[n], 5e-6 * std::abs(exact_y2[n]));
    EXPECT_NEAR(s.expectations[3].derivatives[n], exact_v2[n], 5e-6 * std::abs(exact_v2[n]) + 1e-6);
    EXPECT_NEAR(s.expectations[2].derivatives[n], 6 * y2 * exact_y2[n],
                5e-6 * std::abs(6 * y2 * exact_y2[n]));
    // Both orders are exact.
    EXPECT_LT(s.expectations[1].errors[n], 1e-5 * std::abs(exact_y2[n]));
  }
}

// Values of the finite volumes (docs/functionals.md). The error estimate covers the error.
TEST(ClosureSensitivities, AgreeWithFiniteVolumesInCase1) {
  const auto problem = tests::paper_case(1);
  const MomentSensitivities s = solve_sensitivities(
      problem, {.order = 6, .formulation = Formulation::polar},
      parameter_derivatives(problem, {"system.damping", "system.stiffness", "system.cubic"}));
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const double elasticities[] = {-0.8053, -0.8647, -0.0943};
  for (std::size_t n = 0; n < 3; ++n) {
    SCOPED_TRACE(s.parameters[n]);
    const auto& y2 = s.expectations.at(1);
    const double unit = s.parameter_values[n] / y2.value;
    EXPECT_NEAR(y2.derivatives[n] * unit, elasticities[n], 1e-3);
    EXPECT_LE(std::abs(y2.derivatives[n] * unit - elasticities[n]), y2.errors[n] * unit + 1e-4);
    EXPECT_LT(y2.errors[n] * unit, 2e-2);
  }
}

TEST(ClosureSensitivities, HaveNoErrorEstimateAtOrderTwo) {
  const auto problem = tests::paper_case(1);
  const MomentSensitivities s =
      solve_sensitivities(problem, {.order = 2, .formulation = Formulation::moment},
                          parameter_derivatives(problem, {"system.damping"}));
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  EXPECT_TRUE(std::isnan(s.expectations.at(1).errors.at(0)));
}

TEST(ClosureSensitivities, RefuseWhatTheClosureDoesNotSupport) {
  problem::Problem problem = tests::paper_case(1);
  problem.noise.intensity = 0.1;
  const MomentSensitivities s =
      solve_sensitivities(problem, {.formulation = Formulation::polar},
                          parameter_derivatives(problem, {"system.damping"}));
  EXPECT_EQ(s.status, Status::not_offered);
  EXPECT_FALSE(s.reason.empty());
}

}  // namespace
}  // namespace fpkcheck::epc
