#include "report/figure/frame.hpp"

#include <gtest/gtest.h>

#include "paper_cases.hpp"

namespace fpkcheck::report {
namespace {

TEST(Frame, TitlesAFigureWithTheNameAndTheParameters) {
  auto problem = tests::paper_case(1);
  problem.name = "it's a_b";
  EXPECT_TRUE(figure_title(problem).starts_with("'it''s a\\_b: c = 0.1, k = 1, μ = 0.1, r = 0.98;"))
      << figure_title(problem);
}

TEST(Frame, SizesBothFormats) {
  const std::string text = figure_output("stem", {.width = 12, .height = 34});
  EXPECT_NE(text.find("set terminal svg size 12,34 "), std::string::npos) << text;
  EXPECT_NE(text.find("set terminal pngcairo size 12,34 "), std::string::npos) << text;
  EXPECT_NE(text.find("target = 'stem'.'.'.format"), std::string::npos) << text;
}

}  // namespace
}  // namespace fpkcheck::report
