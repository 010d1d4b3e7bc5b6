#include "numerics/ode/bdf_integrator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fpkcheck::numerics {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

// x' = A x with the eigenvalues -1 and -1000.
OdeSystem stiff_linear_system() {
  const Matrix2d a{{-1, 0}, {999, -1000}};
  return {.rate =
              [a](double, const VectorXd& x, Eigen::Ref<VectorXd> rate) {
                rate = a * x;
                return true;
              },
          .jacobian =
              [a](double, const VectorXd&, Eigen::Ref<MatrixXd> jacobian) {
                jacobian = a;
                return true;
              }};
}

// The solution from (1, 2) is x_1 = e^-t, x_2 = e^-t + e^(-1000 t).
double error_at_one(double tolerance, long* steps = nullptr) {
  BdfIntegrator integrator(stiff_linear_system(), Vector2d(1, 2), {tolerance, tolerance});
  EXPECT_TRUE(integrator.advance_to_time(1)) << integrator.error_message();
  if (steps != nullptr) *steps = integrator.step_count();
  return (integrator.current_state() - Vector2d(std::exp(-1), std::exp(-1))).cwiseAbs().maxCoeff();
}

TEST(BdfIntegrator, MeetsTheToleranceOfAStiffSystem) {
  long steps = 0;
  EXPECT_LT(error_at_one(1e-4, &steps), 1e-3);
  EXPECT_LT(steps, 200) << "an explicit method takes at least 500 steps";
  EXPECT_LT(error_at_one(1e-8), 1e-6);
  EXPECT_LT(error_at_one(1e-10), 1e-8);
}

// x' = -2 t from 1 ends at t = 1, where x = 1 - t^2 = 0. States x < 0 are outside of the domain.
OdeSystem falling_system() {
  return {.rate =
              [](double t, const VectorXd& x, Eigen::Ref<VectorXd> rate) {
                rate[0] = -2 * t;
                return x[0] >= 0;
              },
          .jacobian =
              [](double, const VectorXd& x, Eigen::Ref<MatrixXd> jacobian) {
                jacobian(0, 0) = 0;
                return x[0] >= 0;
              }};
}

TEST(BdfIntegrator, StopsWhereTheSolutionLeavesTheDomain) {
  BdfIntegrator integrator(falling_system(), VectorXd::Ones(1), {1e-8, 1e-8});
  ASSERT_TRUE(integrator.advance_to_time(0.99)) << integrator.error_message();
  EXPECT_NEAR(integrator.current_state()[0], 1 - 0.99 * 0.99, 1e-6);
  EXPECT_FALSE(integrator.advance_to_time(1.1));
}

// A pulse of the length 0.1 at t = 50 after a long rest
double integral_over_pulse(std::optional<double> max_step) {
  const OdeSystem pulse{.rate =
                            [](double t, const VectorXd&, Eigen::Ref<VectorXd> rate) {
                              rate[0] = t > 50 && t < 50.1 ? 1 : 0;
                              return true;
                            },
                        .jacobian =
                            [](double, const VectorXd&, Eigen::Ref<MatrixXd> jacobian) {
                              jacobian(0, 0) = 0;
                              return true;
                            }};
  BdfIntegrator integrator(pulse, VectorXd::Zero(1), {1e-6, 1e-6, max_step});
  EXPECT_TRUE(integrator.advance_to_time(100)) << integrator.error_message();
  return integrator.current_state()[0];
}

TEST(BdfIntegrator, StepsOverNoPulseLongerThanTheLongestStep) {
  EXPECT_NEAR(integral_over_pulse(0.05), 0.1, 1e-3);
  EXPECT_LT(integral_over_pulse({}), 0.05) << "the test needs a pulse that free steps miss";
}

TEST(BdfIntegrator, RethrowsExceptionsOfTheSystem) {
  OdeSystem system = falling_system();
  system.rate = [](double, const VectorXd&, Eigen::Ref<VectorXd>) -> bool {
    throw std::domain_error("rate");
  };
  BdfIntegrator integrator(std::move(system), VectorXd::Ones(1), {1e-8, 1e-8});
  EXPECT_THROW(integrator.advance_to_time(0.1), std::domain_error);
}

}  // namespace
}  // namespace fpkcheck::numerics
