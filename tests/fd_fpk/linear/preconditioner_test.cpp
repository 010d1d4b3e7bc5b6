#include "fd_fpk/linear/preconditioner.hpp"

#include <gtest/gtest.h>

#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "paper_cases.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::fd_fpk {
namespace {

class Preconditioners : public testing::Test {
 protected:
  Preconditioner made() const {
    return {problem_.system, loss_,    on_.excitation,
            options_.impact, on_.grid, transport_order(options_)};
  }
  Eigen::VectorXd solved(const Preconditioner& preconditioner) const {
    Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(on_.grid.size(), -1, 2);
    preconditioner.solve_in_place(b);
    return b;
  }

  problem::Problem problem_ = tests::paper_case(1);
  FiniteVolumeOptions options_{.nx = 16, .nv = 32};
  double loss_ = problem::motion_scales(problem_).slowest_decay_rate;
  PlaneDiscretisation on_ =
      discretise_density_equation(problem_, options_, initial_box(problem_, options_));
};

// I - gamma M equals -gamma M except for a relative difference of 1/(gamma loss), the maximum over
// all modes.
TEST_F(Preconditioners, KeepTheStationaryFactorsForStepsOfManyDecayTimes) {
  constexpr double kDecayTimes = 200;
  Preconditioner kept = made(), fresh = made();
  ASSERT_TRUE(kept.factorise_stationary());
  ASSERT_TRUE(kept.factorise_newton_matrix(kDecayTimes / loss_));
  ASSERT_TRUE(fresh.factorise_newton_matrix(kDecayTimes / loss_));
  EXPECT_EQ(kept.factorisation_count(), 1);
  const Eigen::VectorXd exact = solved(fresh), near = solved(kept);
  EXPECT_LT((near - exact).norm(), 3 / kDecayTimes * exact.norm());
  EXPECT_GT((near - exact).norm(), 0);
}

TEST_F(Preconditioners, FactorAgainForShortStepsAndAfterThem) {
  Preconditioner used = made(), fresh = made();
  ASSERT_TRUE(used.factorise_stationary());
  const Eigen::VectorXd stationary = solved(used);
  ASSERT_TRUE(used.factorise_newton_matrix(100 / loss_));
  ASSERT_TRUE(used.factorise_newton_matrix(0.1 / loss_));
  ASSERT_TRUE(fresh.factorise_newton_matrix(0.1 / loss_));
  EXPECT_EQ(used.factorisation_count(), 2);
  EXPECT_LT((solved(used) - solved(fresh)).norm(), 1e-10 * solved(fresh).norm());
  // The stationary factors have been replaced.
  ASSERT_TRUE(used.factorise_newton_matrix(100 / loss_));
  EXPECT_EQ(used.factorisation_count(), 3);
  ASSERT_TRUE(used.factorise_stationary());
  EXPECT_LT((solved(used) - stationary).norm(), 1e-10 * stationary.norm());
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
