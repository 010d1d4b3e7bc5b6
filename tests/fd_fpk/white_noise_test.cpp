#include <gtest/gtest.h>

#include "elastic_white_noise.hpp"
#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// The paper's four cases with an elastic impact on nx x 2 nx cells, the seventh order.
void expect_errors_below(double most, int nx) {
  for (const int number : {1, 2, 3, 4}) {
    const auto p = tests::make_problem(
        {.cubic = number <= 2 ? 0.1 : 1.0, .restitution = 1, .intensity = number % 2 ? 0.1 : 1.0});
    const auto solution = solve(p, tests::elastic_white_noise(p, 7, nx, 2 * nx)).solution;
    ASSERT_EQ(solution.status, transform::Status::ok) << solution.reason;
    const auto [y, v] = tests::errors_of(solution, p);
    EXPECT_LE(y, most) << "case " << number;
    EXPECT_LE(v, most) << "case " << number;
  }
}

TEST(WhiteNoise, ElasticMarginalsAreExactToAMillionthWithOrderSeven) {
  expect_errors_below(1e-6, 40);
}

TEST(WhiteNoise, AThousandCellsReachTwoHundredThousandths) { expect_errors_below(2e-5, 24); }

}  // namespace
}  // namespace fpkcheck::fd_fpk
