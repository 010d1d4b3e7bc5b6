#include "workflows/sweep/report/page/reasons.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"

namespace fpkcheck::sweep {
namespace {

TEST(Reasons, AreGroupedWithoutTheirNumbers) {
  EXPECT_EQ(replace_numbers("residual 1.5e-03 > 1e-6 after 20 steps"),
            "residual ... > ... after ... steps");
  EXPECT_EQ(replace_numbers("at (-0.5, 3)."), "at (..., ...).");
  EXPECT_EQ(replace_numbers("km4 of epc-moment-n8: L1 of 2.0"), "km4 of epc-moment-n8: L1 of ...");
  EXPECT_EQ(replace_numbers("1e5 cells, 2 errors"), "... cells, ... errors");
  EXPECT_EQ(replace_numbers("a-b 3e"), "a-b ...e");
  EXPECT_EQ(replace_numbers(""), "");
}

TEST(Reasons, AreGroupedTheMostFrequentFirst) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points[3].methods[tests::made_up_moment] = tests::made_up_failure();
  const auto groups = reason_groups(results);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].method, std::size_t{tests::made_up_gaussian});
  EXPECT_EQ(groups[0].count, 4u);
  EXPECT_EQ(groups[0].point, 0u);
  EXPECT_EQ(groups[0].reason, "it is 0.5 off");
  EXPECT_EQ(groups[1].status, transform::Status::failed);
  EXPECT_EQ(groups[1].count, 1u);
  EXPECT_EQ(groups[1].point, 3u);
}

}  // namespace
}  // namespace fpkcheck::sweep
