#include "fd_fpk/linear/linear_cvode.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

// dP/dt = -rates P, with exact solves with I + gamma rates.
const Eigen::VectorXd kRates = Eigen::VectorXd::LinSpaced(6, 0.5, 3);

LinearOdeSystem decay() {
  const auto gamma = std::make_shared<double>(0);
  return {.apply_operator = [](double, const Eigen::VectorXd& p) -> Eigen::VectorXd {
            return -kRates.cwiseProduct(p);
          },
          .factor_shifted_matrix =
              [gamma](double given) {
                *gamma = given;
                return true;
              },
          .approximate_solve =
              [gamma](Eigen::Ref<Eigen::VectorXd> b) {
                b = b.cwiseQuotient((1 + *gamma * kRates.array()).matrix()).eval();
              }};
}

const Eigen::VectorXd kStart = Eigen::VectorXd::Ones(6);
const BdfSettings kControl{.max_order = 2,
                           .relative_tolerance = 1e-7,
                           .absolute_tolerance = 1e-9,
                           .linear_tolerance = 1e-3,
                           .max_steps = 5000};

TEST(LinearCvodeIntegrator, FollowsTheExactSolution) {
  LinearCvodeIntegrator cvode(decay(), kStart, kControl);
  for (const double time : {0.5, 2.0}) {
    const auto [flag, reached] = cvode.advance_to_time(time);
    ASSERT_GE(flag, 0) << cvode.error_message();
    EXPECT_EQ(reached, time);
    const Eigen::VectorXd exact = (-kRates.array() * time).exp();
    EXPECT_LT((cvode.cell_averages() - exact).cwiseAbs().maxCoeff(), 1e-5);
  }
  EXPECT_GT(cvode.step_count(), 10);
  EXPECT_GT(cvode.rhs_evaluation_count(), cvode.step_count());
  EXPECT_GT(cvode.factorisation_count(), 0);
}

TEST(LinearCvodeIntegrator, StopsWithAMessageAtTheMaximumNumberOfSteps) {
  BdfSettings control = kControl;
  control.max_steps = 5;
  LinearCvodeIntegrator cvode(decay(), kStart, control);
  EXPECT_LT(cvode.advance_to_time(2).flag, 0);
  EXPECT_NE(cvode.error_message().find("mxstep"), std::string::npos) << cvode.error_message();
}

TEST(LinearCvodeIntegrator, AFailedFactorisationReturnsAFlag) {
  LinearOdeSystem system = decay();
  system.factor_shifted_matrix = [](double) { return false; };
  LinearCvodeIntegrator cvode(system, kStart, kControl);
  EXPECT_LT(cvode.take_step().flag, 0);
}

struct ThrownByTheSystem {
  int number;
};

// SUNDIALS is C: the exception must not propagate through its frames, and must not be lost.
TEST(LinearCvodeIntegrator, ExceptionsOfCallbacksPropagate) {
  const auto number_of = [](const LinearOdeSystem& system) {
    LinearCvodeIntegrator cvode(system, kStart, kControl);
    try {
      cvode.advance_to_time(2);
    } catch (const ThrownByTheSystem& thrown) {
      return thrown.number;
    }
    return 0;
  };
  EXPECT_EQ(number_of(decay()), 0);
  LinearOdeSystem system = decay();
  system.factor_shifted_matrix = [](double) -> bool { throw ThrownByTheSystem{1}; };
  EXPECT_EQ(number_of(system), 1);
  system = decay();
  system.approximate_solve = [](Eigen::Ref<Eigen::VectorXd>) { throw ThrownByTheSystem{2}; };
  EXPECT_EQ(number_of(system), 2);
  // As right-hand side, in the first call, and as product in GMRES, some calls later.
  for (int calls = 0; calls < 8; ++calls) {
    system = decay();
    system.apply_operator = [apply_operator = decay().apply_operator, left = calls](
                                double t, const Eigen::VectorXd& p) mutable {
      if (left-- == 0) throw ThrownByTheSystem{3};
      return apply_operator(t, p);
    };
    EXPECT_EQ(number_of(system), 3) << calls;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
