#include "workflows/study/grid_convergence_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_up_studies.hpp"
#include "methods/builtin_solvers.hpp"
#include "toy_methods.hpp"

namespace fpkcheck::study {
namespace {

// White noise without losses: the density is smooth, so that every scheme converges at its order.
problem::Problem without_losses() {
  return {"smooth",
          problem::System{{.damping = 0.1, .stiffness = 1.0, .cubic = 0.1, .restitution = 1.0}},
          problem::ImpulseTrain{{1.0, "gaussian", 0.1, 0.0}}};
}

const GridStudyRow& row(const GridStudy& study, int order, int level) {
  const auto found = std::ranges::find_if(
      study.rows, [&](const GridStudyRow& r) { return r.order == order && r.level == level; });
  return *found;
}

TEST(GridStudy, ConvergesAtTheOrderOfEachScheme) {
  std::vector<std::string> told;
  const auto study =
      study_grid(without_losses(),
                 {.equation = problem::DensityEquation::white,
                  .orders = {5, 3, 5},
                  .levels = 4,
                  .coarsest = 0.5,
                  .simulation = {{"time", 3e3}}},
                 methods::builtin_registry(), [&](const methods::RunProgress& progress) {
                   if (progress.fraction == 0) told.push_back(progress.method);
                   EXPECT_EQ(progress.total, 8u + 9u);
                 });
  ASSERT_EQ(study.rows.size(), 8u);
  EXPECT_TRUE(has_converged(study));
  EXPECT_FALSE(row(study, 3, 2).observed);  // an observed order needs three levels
  EXPECT_NEAR(row(study, 3, 4).observed->l1, 3, 0.5);
  EXPECT_NEAR(row(study, 5, 4).observed->l1, 5, 0.7);

  // Distances refer to the limit of the highest order.
  EXPECT_EQ(study.reference_richardson_limit().order, 5);
  EXPECT_EQ(study.reference_richardson_limit().l1->y, 0.0);
  // The limits of both orders differ by less than the error of the finest grid of order 3.
  EXPECT_LT(study.limit_accuracy->y, row(study, 3, 4).l1->y / 3);
  for (const int order : {3, 5}) {
    for (int level = 2; level <= 4; ++level) {
      EXPECT_LT(row(study, order, level).l1->ydot, 0.6 * row(study, order, level - 1).l1->ydot);
    }
  }

  // E[y'^2] = intensity / (2 c) is exact for white noise at r = 1.
  const double limit_of_3 = study.limits[0].density->moments.v2;
  EXPECT_LT(std::abs(limit_of_3 - 0.5), std::abs(row(study, 3, 4).density->moments.v2 - 0.5) / 3);
  EXPECT_NEAR(study.reference_richardson_limit().density->moments.v2, 0.5, 2e-6);

  // Other methods of the same equation, with their times.
  ASSERT_EQ(study.others.size(), 9u);
  EXPECT_EQ(study.others.front().solution.id(), "epc-moment-white-n2");
  EXPECT_EQ(study.others.back().solution.id(), "mcs-white");
  EXPECT_TRUE(study.others.back().solution.sampling);
  for (const auto& other : study.others) {
    EXPECT_GT(other.solution.seconds, 0) << other.solution.id();
    EXPECT_TRUE(other.l1) << other.solution.id();
  }
  // Exact from n = 4 on: the distance is the error of the limit.
  EXPECT_LT(study.others.at(1).l1->y, 1e-4);
  EXPECT_EQ(told.front(), "order 3, level 1");
  EXPECT_EQ(told.back(), "mcs-white");
}

// All levels have the smallest grid, so that nothing converges and there is no limit.
TEST(GridStudy, HasNoLimitWithoutConvergence) {
  const auto study =
      study_grid(tests::paper_case(1), {.orders = {5}, .levels = 3, .coarsest = 0.02},
                 tests::toy_registry(), {});
  EXPECT_FALSE(study.reference_richardson_limit().failure.empty());
  EXPECT_FALSE(study.reference_richardson_limit().density);
  EXPECT_TRUE(study.others.empty());
  EXPECT_FALSE(has_converged(study));
  EXPECT_TRUE(study_figure(study).panels.empty());
}

TEST(GridStudy, HasConvergedUnlessAFinestGridFailedOrDidNotConverge) {
  auto study = tests::made_up_grid_study();
  study.rows[0].solution.status = transform::Status::failed;
  EXPECT_TRUE(has_converged(study));
  study.rows[2].solution.status = transform::Status::failed;
  EXPECT_FALSE(has_converged(study));
  study.rows[2].solution.status = transform::Status::not_converged;
  EXPECT_FALSE(has_converged(study));
  study.rows[2].solution.status = transform::Status::inadmissible;
  EXPECT_TRUE(has_converged(study));
}

}  // namespace
}  // namespace fpkcheck::study
