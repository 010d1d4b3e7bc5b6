#include "fd_fpk/linear/gmres.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fpkcheck::fd_fpk {
namespace {

const Eigen::VectorXd kRight = Eigen::VectorXd::LinSpaced(12, 1, 2);
const Eigen::VectorXd kWeights = Eigen::VectorXd::Ones(12);

// A diagonal matrix with twelve eigenvalues, 1 .. 12, and an approximation of it.
Eigen::VectorXd diagonal() { return Eigen::VectorXd::LinSpaced(12, 1, 12); }
Eigen::VectorXd times(const Eigen::VectorXd& x) { return diagonal().cwiseProduct(x); }
void nearly(Eigen::Ref<Eigen::VectorXd> b) {
  b = b.cwiseQuotient((diagonal().array() + 0.5).matrix()).eval();
}

TEST(Gmres, SolvesToTheTolerance) {
  const auto [solution, iterations, failure] =
      solve_by_gmres(times, nearly, kRight, kWeights, 1e-12);
  ASSERT_TRUE(solution) << failure;
  EXPECT_LT((times(*solution) - kRight).norm(), 1e-12 * kRight.norm());
  EXPECT_LE(iterations, 24);
}

TEST(Gmres, ReportsAFailureToConverge) {
  // b has no component in the range of this matrix.
  const auto nothing = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(0 * x); };
  const auto [solution, iterations, failure] =
      solve_by_gmres(nothing, nearly, kRight, kWeights, 1e-12);
  EXPECT_FALSE(solution);
  EXPECT_NE(failure.find("did not converge"), std::string::npos) << failure;
}

// GMRES may stagnate for minutes on a fine grid, and no other code checks the deadline meanwhile.
TEST(Gmres, StopsAtTheDeadline) {
  int products = 0;
  const auto count_until = [&](int last, const base::Deadline& deadline) {
    products = 0;
    return solve_by_gmres(
        [&](const Eigen::VectorXd& x) {
          while (products == last && !deadline.has_deadline_passed()) {
          }
          ++products;
          return times(x);
        },
        nearly, kRight, kWeights, 1e-12, deadline);
  };
  const auto late = count_until(0, base::Deadline(0));
  EXPECT_FALSE(late.solution);
  EXPECT_EQ(products, 0);
  EXPECT_NE(late.failure.find("max_seconds"), std::string::npos) << late.failure;
  const auto midway = count_until(3, base::Deadline(0.05));
  EXPECT_FALSE(midway.solution);
  EXPECT_LE(products, 4);
  EXPECT_TRUE(count_until(-1, base::Deadline::without_time_limit()).solution);
  EXPECT_GT(products, 4);
}

struct Thrown {
  int number;
};

// SUNDIALS is C: the exception must not propagate through its frames, and must not be lost.
TEST(Gmres, ExceptionsOfCallbacksPropagate) {
  const LinearMap throwing_map = [](const Eigen::VectorXd&) -> Eigen::VectorXd { throw Thrown{7}; };
  const ApproximateLinearSolver throwing_solve = [](Eigen::Ref<Eigen::VectorXd>) {
    throw Thrown{8};
  };
  const auto number_of = [&](const LinearMap& a, const ApproximateLinearSolver& solve) {
    try {
      solve_by_gmres(a, solve, kRight, kWeights, 1e-12);
    } catch (const Thrown& thrown) {
      return thrown.number;
    }
    return 0;
  };
  EXPECT_EQ(number_of(throwing_map, nearly), 7);
  EXPECT_EQ(number_of(times, throwing_solve), 8);
  EXPECT_EQ(number_of(times, nearly), 0);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
