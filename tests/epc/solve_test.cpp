#include "epc/solve.hpp"

#include <gtest/gtest.h>

#include "base/input_error.hpp"
#include "closures.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc {
namespace {

TEST(Closure, HasTheIdentityOfItsOptions) {
  const auto p = tests::paper_case(1);
  for (const auto& [formulation, name, meaning] : kFormulationNames) {
    const Options options = tests::closure(formulation, 4);
    const auto [solution, summary] = solve(p, options);
    EXPECT_EQ(solution.identity, identity(options)) << name;
    EXPECT_EQ(solution.id(), id(options));
    EXPECT_GT(solution.seconds, 0);
    EXPECT_EQ(solution.metrics, metrics(summary, solution.moments));
  }
}

// If no root is found, the solution has an identity and no density.
TEST(Closure, NamesAProblemWithoutARoot) {
  const auto solution = solve(tests::paper_case(1), {.order = 8}).solution;
  EXPECT_EQ(solution.status, transform::Status::not_converged);
  EXPECT_EQ(solution.id(), "epc-gaussian-n8");
  EXPECT_FALSE(solution.density.has_value());
}

// For rare impulses and strong losses the search is long, and ends at the deadline with a reason.
TEST(Closure, EndsAtTheDeadline) {
  const auto p = tests::make_problem({.restitution = 0.6, .rate = 0.05});
  for (const auto formulation : {Formulation::moment, Formulation::polar}) {
    Options options = tests::closure(formulation, 8);
    options.max_seconds = 1e-9;
    const auto solution = solve(p, options).solution;
    EXPECT_EQ(solution.status, transform::Status::not_converged);
    EXPECT_NE(solution.reason.find("no root was found in 1e-09 s (max_seconds)"), std::string::npos)
        << solution.reason;
    EXPECT_LT(solution.seconds, 1);
  }
}

TEST(Closure, RefusesOptionsThatAreNotValid) {
  EXPECT_THROW(solve(tests::paper_case(1), {.order = 5}), InputError);
}

}  // namespace
}  // namespace fpkcheck::epc
