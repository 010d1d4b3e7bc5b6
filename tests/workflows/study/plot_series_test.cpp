#include "workflows/study/plot_series.hpp"

#include <gtest/gtest.h>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(Picture, NeighboursWithALabelFormASeriesWithTheStyleOfTheMiddle) {
  const auto study = tests::made_up_order_study();
  const auto all = make_series(
      study.rows, "block_", [](const ClosureOrderRow& row) { return row.formulation; },
      [](const ClosureOrderRow& row) { return std::to_string(row.order) + '\n'; });
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].block, "block_0");
  EXPECT_EQ(all[0].points, "2\n4\n8\n");
  EXPECT_EQ(all[1].label, "moment");
  EXPECT_EQ(all[1].points, "4\n6\n");
  EXPECT_EQ(all[1].plot_style.colour, study.rows[3].solution.identity.plot_style.colour);
}

}  // namespace
}  // namespace fpkcheck::study
