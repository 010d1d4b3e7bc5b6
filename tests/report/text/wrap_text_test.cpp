#include "report/text/text_layout.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

TEST(WrapText, BreaksBetweenWordsAndIndents) {
  EXPECT_EQ(wrap_text("  one two three", 9, 4), "  one two\n    three\n");
  EXPECT_EQ(wrap_text("exactly ten", 11), "exactly ten\n");
  EXPECT_EQ(wrap_text("exactly ten", 10), "exactly\nten\n");
  EXPECT_EQ(wrap_text("unbreakable", 4), "unbreakable\n");
}

}  // namespace
}  // namespace fpkcheck::report
