#include <gtest/gtest.h>

#include "compare/axes.hpp"
#include "fd_fpk/solve.hpp"
#include "mcs/solve.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "random_problem.hpp"

// What `ok` and a stated error are worth on problems over the whole range that the program accepts:
// fpkcheck_random has any number of them (docs/limits.md).
namespace fpkcheck::methods {
namespace {

using transform::Variable;

TEST(RandomProblems, FiniteDifferencesThatSayOkAreWithinTheirStatedError) {
  // From a twentieth of an impulse per decay time to thousands, all laws, r from 0.05 to 1.
  for (const std::uint64_t number : {3,  10, 13, 18, 19, 25,  29,  33,  43,  60,  62,  66,
                                     75, 86, 94, 98, 99, 100, 101, 104, 106, 113, 115, 119}) {
    const auto p = tests::random_problem(number);
    SCOPED_TRACE(p.name + ": " + problem::parameters_text(p));
    const auto axes = compare::comparison_axes(p);
    const auto solution = fd_fpk::solve(p, {.stepper = fd_fpk::Stepper::direct}).solution;
    EXPECT_EQ(solution.status, transform::Status::ok) << solution.reason;
    ASSERT_TRUE(solution.error);
    const double decay = problem::slowest_decay(problem::equivalent_linearisation(p));
    const auto judge =
        mcs::solve(p, {.time = 1e5 / decay, .y_edges = axes.y_edges, .v_edges = axes.v_edges})
            .solution;
    const auto apart = [&](Variable variable) {
      const auto& edges = compare::edges(axes, variable);
      return transform::l1(transform::marginal(solution, variable, edges),
                           transform::marginal(judge, variable, edges));
    };
    // Twice the stated error, and what 99 of 100 simulations stay below.
    EXPECT_LT(apart(Variable::y), 2 * solution.error->y_l1 + *judge.sampling->y_99);
    EXPECT_LT(apart(Variable::ydot), 2 * solution.error->ydot_l1 + *judge.sampling->ydot_99);
  }
}

}  // namespace
}  // namespace fpkcheck::methods
