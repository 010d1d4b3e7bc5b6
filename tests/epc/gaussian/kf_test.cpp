#include <gtest/gtest.h>

#include <cmath>

#include "epc/gaussian/gaussian_weighted_basis.hpp"
#include "epc/selection_policy.hpp"
#include "epc/solve.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using transform::Status;

ClosureOptions kf(int order) { return {.order = order, .equation = DensityEquation::kf}; }

TEST(KolmogorovFeller, IsNearerToTheJumpEquationThanTheCutSeries) {
  // Reference: `kf` with r = 1 and lambda = 1, by an independent spectral computation.
  for (const auto& [cubic, y2, y4] : {std::tuple{0.1, 0.44181, 0.58190}, {1.0, 0.28632, 0.21368}}) {
    const problem::Problem p = tests::make_problem({.cubic = cubic, .restitution = 1});
    const auto whole = solve_closure(p, kf(6)).solution,
               cut = solve_closure(p, {.order = 6}).solution;
    ASSERT_EQ(whole.status, Status::ok) << whole.reason;
    EXPECT_LT(std::abs(whole.moments.y2 - y2), 2e-4);
    EXPECT_GT(std::abs(cut.moments.y2 - y2), 4e-4);
    EXPECT_NEAR(whole.moments.y4, y4, 1e-3);
    EXPECT_NEAR(whole.moments.v2, 0.5, 2e-4);
  }
}

TEST(KolmogorovFeller, RootsAreInsensitiveToTheDisc) {
  for (const int order : {4, 6}) {
    const auto [solution, summary] = solve_closure(tests::paper_case(1), kf(order));
    ASSERT_NE(solution.status, Status::not_converged) << solution.reason;
    EXPECT_LT(summary.residual, 1e-13);
    EXPECT_LT(summary.disc_sensitivity.value(), 0.003);
  }
  EXPECT_FALSE(
      solve_closure(tests::paper_case(1), {.order = 4}).summary.disc_sensitivity.has_value());
}

TEST(KolmogorovFeller, OrderEightIsADensityInCaseTwo) {
  const auto [solution, summary] = solve_closure(tests::paper_case(2), kf(8));
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_LT(summary.distance_to_previous.value(), 0.01);
  EXPECT_NEAR(solution.moments.y2, 2.5913, 2e-4);
}

TEST(KolmogorovFeller, TheGeneralSetGivesThePointSymmetricSolution) {
  const problem::Problem p = tests::make_problem({.mean = 0.1, .law = "two_point"});
  const ClosureResult half = solve_closure(p, kf(4));
  ClosureOptions general = kf(4);
  general.monomials = MonomialSet::general;
  const ClosureResult whole = solve_closure(p, general);
  ASSERT_EQ(half.solution.status, Status::ok) << half.solution.reason;
  EXPECT_EQ(whole.solution.status, Status::ok) << whole.solution.reason;
  const GaussianWeightedBasis all(4, MonomialSet::general, gaussian_weight_deviations(p));
  EXPECT_LT((all.scaled_coefficients(half.summary.coefficients) -
             all.scaled_coefficients(whole.summary.coefficients))
                .norm(),
            1e-10);
  // The mean, and with it a nonzero third moment, shifts the response outwards.
  EXPECT_GT(
      half.solution.moments.y2,
      solve_closure(tests::make_problem({.law = "two_point"}), kf(4)).solution.moments.y2 + 0.02);
}

TEST(KolmogorovFeller, FrequentImpulsesAreTheCutSeries) {
  const problem::Problem p = tests::make_problem({.rate = 100});
  const auto whole = solve_closure(p, kf(6)).solution,
             cut = solve_closure(p, {.order = 6}).solution;
  EXPECT_NEAR(whole.moments.y4, cut.moments.y4, 1e-6);
  EXPECT_NEAR(whole.moments.v4, cut.moments.v4, 1e-6);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
