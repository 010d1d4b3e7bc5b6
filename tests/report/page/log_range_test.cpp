#include "report/page/log_range.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

TEST(LogAxisRange, HoldsAllThatHasALogarithmWithRoomAtBothEnds) {
  LogAxisRange range;
  for (const double value : {1e-3, 10.0, 0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    range.include(value);
  }
  const auto [from, to] = range.exponents(0.5, 0.25);
  EXPECT_DOUBLE_EQ(from, -3.5);
  EXPECT_DOUBLE_EQ(to, 1.25);
}

TEST(LogAxisRange, OfNothingIsSomeRange) {
  const auto [from, to] = LogAxisRange().exponents(0.5, 0.5);
  EXPECT_LT(from, to);
}

}  // namespace
}  // namespace fpkcheck::report
