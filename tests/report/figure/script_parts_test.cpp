#include "report/figure/script_parts.hpp"

#include <gtest/gtest.h>

#include "made_up_solutions.hpp"

namespace fpkcheck::report {
namespace {

TEST(ScriptParts, SeriesHaveTheColoursOfTheirMethodsAndDifferInTheirMarks) {
  const auto looks = series_looks(std::vector{tests::closure_identity("gaussian", 2),
                                              tests::closure_identity("moment", 2),
                                              tests::closure_identity("gaussian", 4)});
  ASSERT_EQ(looks.size(), 3u);
  EXPECT_EQ(looks[0].colour, "#D55E00");
  EXPECT_EQ(looks[1].colour, "#CC79A7");
  EXPECT_NE(looks[0].filled, looks[1].filled);
  EXPECT_NE(looks[0].filled, looks[0].open);
  EXPECT_EQ(looks[1].dash, 1);
  EXPECT_EQ(looks[2].dash, 2);  // the second of its family
}

TEST(ScriptParts, PartsAreLinesOfAScript) {
  EXPECT_EQ(data_block("a", "1 2\n"), "$a << EOD\n1 2\nEOD\n");
  EXPECT_EQ(margins({0.1, 0.9, 0.8, 0.2}),
            "set lmargin at screen 0.1\nset rmargin at screen 0.9\n"
            "set tmargin at screen 0.8\nset bmargin at screen 0.2\n");
}

}  // namespace
}  // namespace fpkcheck::report
