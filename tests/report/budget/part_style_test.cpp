#include "report/budget/part_style.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/input_error.hpp"
#include "compare/error_budget.hpp"

namespace fpkcheck::report {
namespace {

TEST(PartStyle, DistinguishesAllLinks) {
  std::set<std::string> colours{budget_part_colour("closure + impact")};
  for (const auto& link : compare::kApproximationNames) {
    EXPECT_TRUE(colours.insert(budget_part_colour(std::string(link.name))).second) << link.name;
  }
  std::set<std::string> patterns;
  for (const char* part :
       {"impact", "white noise", "discretisation", "sampling", "closure + impact"}) {
    EXPECT_TRUE(patterns.insert(budget_part_fill_pattern(part)).second) << part;
  }
  EXPECT_EQ(budget_part_fill_pattern("closure"), std::string());
  EXPECT_EQ(budget_part_colour("impact + truncation"),
            std::string(budget_part_colour("closure + impact")));
}

TEST(PartStyle, HatchesBarsOfEqualGreyAndMakesThemPaler) {
  EXPECT_EQ(budget_part_bar_style("closure", false),
            "with boxes fillstyle solid 1 border rgb '#D55E00' linecolor rgb '#D55E00'");
  EXPECT_EQ(budget_part_bar_style("closure", true),
            "with boxes fillstyle solid 0.3 border rgb '#D55E00' linecolor rgb '#D55E00'");
  EXPECT_EQ(budget_part_bar_style("impact", false),
            "with boxes fillstyle pattern 4 border rgb '#E69F00' linecolor rgb '#E69F00'");
  // 255 - 0.3 (255 - colour): E6, 9F, 00.
  EXPECT_EQ(budget_part_bar_style("impact", true),
            "with boxes fillstyle pattern 4 border rgb '#E69F00' linecolor rgb '#F8E3B3'");
  std::set<std::string> hatches;
  for (const char* part :
       {"impact", "white noise", "discretisation", "sampling", "closure + impact"}) {
    const std::string boxes = budget_part_bar_style(part, false);
    const auto pattern = boxes.find("pattern");
    ASSERT_NE(pattern, std::string::npos) << part;
    EXPECT_TRUE(hatches.insert(boxes.substr(pattern, 9)).second) << part;
  }
}

TEST(PartStyle, RejectsAnUnknownPart) { EXPECT_THROW(budget_part_colour("luck"), InputError); }

}  // namespace
}  // namespace fpkcheck::report
