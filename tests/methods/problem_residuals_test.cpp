#include "methods/problem_residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "methods/builtin.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::Status;
using transform::Variable;

Solution solved(const std::string& id, const parameters::Values& given = {}) {
  const auto p = tests::paper_case(1);
  const auto axes = compare::comparison_axes(p);
  return solve_by(*builtin().by_id(id, given), p, {axes, {}});
}

TEST(MeasuredError, OfAClosureIsItsDistanceToTheJumpEquation) {
  const auto p = tests::paper_case(1);
  const auto axes = compare::comparison_axes(p);
  const auto reference = solved("fd-kf");
  // From a quarter to a hundredth of a per cent, the model's error included.
  for (const char* id : {"epc-gaussian-n2", "epc-gaussian-n4", "epc-moment-n4", "epc-moment-n8",
                         "epc-moment-white-n8", "epc-polar-n4"}) {
    const auto closure = solved(id);
    ASSERT_TRUE(closure.error) << id;
    for (const auto variable : transform::kVariables) {
      const auto& edges = compare::edges(axes, variable);
      const double apart = transform::l1(transform::marginal(closure, variable, edges),
                                         transform::marginal(reference, variable, edges));
      EXPECT_NEAR(transform::l1(*closure.error, variable) / apart, 1.6, 0.3) << id << apart;
    }
  }
}

TEST(MeasuredError, DecidesWhetherAClosureIsOk) {
  const auto linearised = solved("epc-gaussian-n2");
  EXPECT_EQ(linearised.status, Status::inaccurate);
  EXPECT_NE(linearised.reason.find("0.043 in p(y')"), std::string::npos) << linearised.reason;
  EXPECT_TRUE(linearised.density);
  EXPECT_EQ(solved("epc-gaussian-n2", {{"accuracy", 0.05}}).status, Status::ok);
  EXPECT_EQ(solved("epc-moment-n8").status, Status::ok);
  EXPECT_EQ(solved("epc-moment-n8", {{"accuracy", 1e-4}}).status, Status::inaccurate);
}

TEST(MeasuredError, LeavesOtherVerdictsAlone) {
  Solution solution;
  solution.status = Status::inadmissible;
  solution.reason = "no density";
  solution.density = transform::SmoothDensity{
      [](double y, double v) { return std::exp(-(y * y + v * v)) * 2 / std::numbers::pi; }, 6, 6};
  const ProblemResiduals residuals(tests::paper_case(1));
  state_measured_error(residuals, 1e-3, solution);
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_EQ(solution.reason, "no density");
  EXPECT_TRUE(solution.error);
  solution.status = Status::ok;
  state_measured_error(residuals, 1e-3, solution);
  EXPECT_EQ(solution.status, Status::inaccurate);

  Solution without;
  without.status = Status::not_converged;
  state_measured_error(residuals, 1e-3, without);
  EXPECT_FALSE(without.error);
}

TEST(MeasuredError, OfWhatHasNoMeanIsUnknownAndSoNotOk) {
  Solution solution;
  solution.status = Status::ok;
  solution.density = transform::SmoothDensity{[](double, double) { return 0.0; }, 6, 6};
  state_measured_error(ProblemResiduals(tests::paper_case(1)), 1e-3, solution);
  EXPECT_EQ(solution.status, Status::inaccurate);
  EXPECT_NE(solution.reason.find("cannot be measured"), std::string::npos);
}

TEST(ProblemResiduals, AreFittedOnceForAllThreads) {
  const ProblemResiduals residuals(tests::paper_case(2));
  std::vector<const dual::DensityResiduals*> seen(4);
  {
    std::vector<std::jthread> threads;
    for (auto& one : seen) threads.emplace_back([&] { one = residuals.get(); });
  }
  EXPECT_NE(seen[0], nullptr);
  for (const auto* one : seen) EXPECT_EQ(one, seen[0]);
}

}  // namespace
}  // namespace fpkcheck::methods
