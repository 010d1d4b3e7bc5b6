#include "workflows/study/regularisation.hpp"

#include <gtest/gtest.h>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(RegularisationStudy, HasTheGrowthOfEachRow) {
  const auto study = tests::made_up_regularisation_study();
  EXPECT_FALSE(study.rows[0].growth_rate);
  EXPECT_FALSE(study.rows[0].symbol_grows);
  EXPECT_EQ(study.rows[2].growth_rate, 320.0);
  EXPECT_TRUE(study.rows[2].symbol_grows);
  EXPECT_FALSE(study.rows[7].growth_rate);
}

TEST(RegularisationStudy, HasConvergedIfTheDefaultLengthHasADensityOnTheFinestStep) {
  auto study = tests::made_up_regularisation_study();
  EXPECT_TRUE(has_converged(study));
  study.rows[6].growth_rate = 1;
  EXPECT_FALSE(has_converged(study));
  study = tests::made_up_regularisation_study();
  study.rows[6].l1_y.reset();
  EXPECT_FALSE(has_converged(study));
  study.rows.clear();
  EXPECT_FALSE(has_converged(study));
}

}  // namespace
}  // namespace fpkcheck::study
