#include <gtest/gtest.h>

#include "base/input_error.hpp"
#include "closures.hpp"
#include "epc/solve.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc {
namespace {

TEST(Closure, HasTheIdentityOfItsOptions) {
  const auto p = tests::paper_case(1);
  for (const auto& [formulation, name, meaning] : kFormulationNames) {
    const ClosureOptions options = tests::closure_options(formulation, 4);
    const auto [solution, summary] = solve_closure(p, options);
    EXPECT_EQ(solution.identity, solution_identity(options)) << name;
    EXPECT_EQ(solution.id(), solution_id(options));
    EXPECT_GT(solution.seconds, 0);
    EXPECT_EQ(solution.metrics, solver_metrics(summary, solution.moments));
  }
}

// If no root is found, the solution has an identity and no density.
TEST(Closure, NamesAProblemWithoutARoot) {
  const auto solution = solve_closure(tests::paper_case(1), {.order = 8}).solution;
  EXPECT_EQ(solution.status, transform::Status::not_converged);
  EXPECT_EQ(solution.id(), "epc-gaussian-n8");
  EXPECT_FALSE(solution.density.has_value());
}

// For rare impulses and strong losses the search is long, and ends at the deadline with a reason.
TEST(Closure, EndsAtTheDeadline) {
  const auto p = tests::make_problem({.restitution = 0.6, .rate = 0.05});
  for (const auto formulation : {Formulation::moment, Formulation::polar}) {
    ClosureOptions options = tests::closure_options(formulation, 8);
    options.max_seconds = 1e-9;
    const auto solution = solve_closure(p, options).solution;
    EXPECT_EQ(solution.status, transform::Status::not_converged);
    EXPECT_NE(solution.reason.find("no root was found in 1e-09 s (max_seconds)"), std::string::npos)
        << solution.reason;
    EXPECT_LT(solution.seconds, 1);
  }
}

TEST(Closure, RefusesOptionsThatAreNotValid) {
  EXPECT_THROW(solve_closure(tests::paper_case(1), {.order = 5}), InputError);
}

using problem::System;

std::string unsupported_reason_of(Formulation formulation, const problem::Problem& problem) {
  return unsupported_reason(tests::in_wall_coordinates(problem),
                            tests::closure_options(formulation, 4));
}

TEST(Applicability, EveryFormulationTreatsThePapersClass) {
  for (const auto& formulation : kFormulationNames) {
    EXPECT_EQ(unsupported_reason_of(formulation.value, tests::paper_case(1)), "")
        << formulation.name;
  }
}

TEST(Applicability, MomentTreatsEveryDomainButAtomsAndCollapse) {
  const auto impulses = tests::gaussian_impulses(1, 0.1);
  const System well({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true});
  const System gap({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 0.1});
  const System preload({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7});
  EXPECT_EQ(unsupported_reason_of(Formulation::moment, tests::with_impulses(well, impulses)), "");
  EXPECT_EQ(unsupported_reason_of(Formulation::moment, tests::with_impulses(gap, impulses)), "");
  EXPECT_EQ(unsupported_reason_of(Formulation::moment, tests::with_noise(preload, 0.1)), "");
  EXPECT_NE(unsupported_reason_of(Formulation::moment, tests::with_impulses(preload, impulses)),
            "");
  EXPECT_NE(unsupported_reason_of(Formulation::moment, tests::with_noise(gap, 0.1)), "");
}

TEST(Applicability, GaussianNeedsOneWallOrNone) {
  const System well({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true});
  const System gap({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 0.9});
  EXPECT_EQ(unsupported_reason_of(Formulation::gaussian, tests::with_noise(well, 0.1)), "");
  const auto impulses = tests::gaussian_impulses(1, 0.1);
  EXPECT_EQ(unsupported_reason_of(Formulation::gaussian, tests::with_impulses(gap, impulses)), "");
  // Unsupported: atoms, a second wall, and damping that changes under folding.
  const System preload({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7});
  EXPECT_NE(unsupported_reason_of(Formulation::gaussian, tests::with_impulses(preload, impulses)),
            "");
  const System two({.damping = 0.1, .stiffness = 1},
                   {.left = -0.5, .left_restitution = 0.9, .right = 1, .right_restitution = 0.9});
  EXPECT_NE(unsupported_reason_of(Formulation::gaussian, tests::with_impulses(two, impulses)), "");
  const System cycle({.damping = 0.1, .van_der_pol = 0.2, .stiffness = 1},
                     {.left = -0.5, .left_restitution = 0.9});
  EXPECT_NE(unsupported_reason_of(Formulation::gaussian, tests::with_impulses(cycle, impulses)),
            "");
  const auto with_jumps = tests::closure_options(Formulation::gaussian, 4, DensityEquation::kf);
  EXPECT_NE(unsupported_reason(tests::with_noise(well, 0.1), with_jumps), "");
}

TEST(Applicability, PolarNeedsAWallAtAnEquilibriumWithoutNoise) {
  const System gap({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 0.9});
  const System paper({.damping = 0.1, .stiffness = 1, .restitution = 0.9});
  EXPECT_NE(unsupported_reason_of(Formulation::polar,
                                  tests::with_impulses(gap, tests::gaussian_impulses(1, 0.1))),
            "");
  EXPECT_NE(unsupported_reason_of(Formulation::polar, tests::with_noise(paper, 0.1)), "");
}

TEST(Applicability, PolarTreatsRestInContactWithOneWall) {
  const auto impulses = tests::gaussian_impulses(1, 0.1);
  const System preload({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7});
  EXPECT_EQ(unsupported_reason_of(Formulation::polar, tests::with_impulses(preload, impulses)), "");
  EXPECT_NE(unsupported_reason_of(Formulation::polar, tests::with_noise(preload, 0.1)), "");
  const System stops({.damping = 0.1, .stiffness = -1, .cubic = 0.2},
                     {.left = -1, .left_restitution = 0.7, .right = 1, .right_restitution = 0.7});
  EXPECT_NE(unsupported_reason_of(Formulation::polar, tests::with_impulses(stops, impulses))
                .find("presses everywhere"),
            std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::epc
