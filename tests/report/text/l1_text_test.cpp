#include "report/text/l1_text.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

TEST(L1Text, HasFiveDecimalsAndTwoDigitsBelowThem) {
  EXPECT_EQ(l1_text(0.123456), "0.12346");
  EXPECT_EQ(l1_text(1e-5), "1.0e-05");
  EXPECT_EQ(l1_text(4.4e-6), "4.4e-06");
  EXPECT_EQ(l1_text(0), "0");
}

}  // namespace
}  // namespace fpkcheck::report
