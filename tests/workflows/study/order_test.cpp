#include "workflows/study/closure_order_study.hpp"

#include <gtest/gtest.h>

#include "made_up_studies.hpp"
#include "methods/builtin_solvers.hpp"
#include "refusal.hpp"
#include "toy_methods.hpp"

namespace fpkcheck::study {
namespace {

TEST(ClosureOrderStudy, ComparesEveryOrderWithADiscretisationOfTheFullProblem) {
  const auto study = study_closure_orders(tests::paper_case(1), {{"moment", "gaussian"}, {4, 2, 4}},
                                          methods::builtin_registry(), {});
  EXPECT_EQ(study.reference.id(), "fd-kf");
  EXPECT_TRUE(study.reference.has_status_ok());
  ASSERT_EQ(study.rows.size(), 4u);
  const char* const ids[] = {"epc-moment-n2", "epc-moment-n4", "epc-gaussian-n2",
                             "epc-gaussian-n4"};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(study.rows[k].solution.id(), ids[k]);
  EXPECT_TRUE(study.rows[0].must_converge);
  EXPECT_FALSE(study.rows[2].must_converge);
  EXPECT_LT(study.rows[1].l1->ydot, study.rows[0].l1->ydot / 2);
  EXPECT_GT(*study.rows[0].tail_ydot, 0.5);
  EXPECT_LT(*study.rows[1].tail_ydot, *study.rows[0].tail_ydot);
  EXPECT_FALSE(study.rows[3].solution.has_status_ok());  // need not converge
  EXPECT_TRUE(has_converged(study));
}

TEST(ClosureOrderStudy, AcceptsAnExternallyRegisteredClosure) {
  const auto registry = tests::toy_registry();
  EXPECT_EQ(closure_formulations(registry),
            (std::vector<std::string>{"flat", "flat-white", "other-flat", "other-flat-white"}));
  const auto study = study_closure_orders(tests::paper_case(1), {{"flat"}, {2, 6}}, registry, {});
  EXPECT_EQ(study.reference.id(), "cells");
  ASSERT_EQ(study.rows.size(), 2u);
  EXPECT_EQ(study.rows[1].solution.id(), "toy-flat-n6");
  EXPECT_TRUE(study.rows[1].must_converge);
  EXPECT_LT(study.rows[1].l1->y, study.rows[0].l1->y / 2);
}

std::string refusal(const ClosureOrderStudyOptions& options,
                    const methods::SolverRegistry& registry) {
  return tests::refusal([&] { study_closure_orders(tests::paper_case(1), options, registry, {}); });
}

TEST(ClosureOrderStudy, RefusesUnknownFormulationsAndOrders) {
  const auto registry = tests::toy_registry();
  EXPECT_EQ(refusal({{"round"}, {2}}, registry),
            "--formulations: 'round' is no formulation; use some of flat, flat-white, other-flat, "
            "other-flat-white");
  EXPECT_TRUE(refusal({{"flat"}, {3}}, registry).starts_with("toy order = 3 (must be"));
  EXPECT_EQ(refusal({{"flat"}, {40}}, registry),
            "--orders 40: there is no toy-flat-n40; leave this order out");
}

TEST(ClosureOrderStudy, RefusesARegistryWithoutAReference) {
  methods::SolverRegistry registry;
  registry.add_solver(
      tests::toy_solver({"toy", "toy-flat", transform::SolutionRole::closure, true}));
  EXPECT_TRUE(refusal({{"flat"}, {2}}, registry).starts_with("no reference for the closures:"));
}

TEST(ClosureOrderStudy, HasConvergedIfRequiredClosuresAreOk) {
  auto study = tests::made_up_order_study();
  EXPECT_TRUE(has_converged(study));  // gaussian need not converge
  study.rows.back().solution.status = transform::Status::inadmissible;
  EXPECT_FALSE(has_converged(study));
  study = tests::made_up_order_study();
  study.reference.status = transform::Status::not_converged;
  EXPECT_FALSE(has_converged(study));
}

TEST(ClosureOrderStudy, FindsTheBranchInTheMetrics) {
  const auto study = tests::made_up_order_study();
  EXPECT_FALSE(read_solution_branch(study.rows[0].solution.metrics));
  const auto followed = read_solution_branch(study.rows[2].solution.metrics);
  ASSERT_TRUE(followed);
  EXPECT_EQ(followed->end, "white_noise");
  EXPECT_EQ(followed->largest_fraction, 0.655);
  ASSERT_EQ(followed->points.size(), 2u);
  EXPECT_EQ(followed->points[1].norm, 2.5);
  EXPECT_FALSE(followed->points[0].fold);
  EXPECT_TRUE(followed->points[1].fold);
}

}  // namespace
}  // namespace fpkcheck::study
