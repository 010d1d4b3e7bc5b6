#include "report/text/wrapped.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

TEST(WrappedText, BreaksBetweenWordsAndIndents) {
  EXPECT_EQ(wrapped("  one two three", 9, 4), "  one two\n    three\n");
  EXPECT_EQ(wrapped("exactly ten", 11), "exactly ten\n");
  EXPECT_EQ(wrapped("exactly ten", 10), "exactly\nten\n");
  EXPECT_EQ(wrapped("unbreakable", 4), "unbreakable\n");
}

}  // namespace
}  // namespace fpkcheck::report
