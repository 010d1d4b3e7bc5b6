#include "report/figure/panel.hpp"

#include <gtest/gtest.h>

#include <set>

#include "changed_case.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;

TEST(Panel, DrawsEverythingAsItIsTold) {
  EXPECT_EQ(drawn_with({.colour = "#123456", .dash = "(10,4)", .width = 2.5}, false),
            "with lines linewidth 2.5 dashtype (10,4) linecolor rgb '#123456'");
  EXPECT_EQ(drawn_with({}, true),
            "with lines linewidth 1.5 dashtype solid linecolor rgb '#777777'");
  const transform::Look points{.as_points = true};
  EXPECT_TRUE(drawn_with(points, true).starts_with("with yerrorbars pointtype 6"));
  EXPECT_TRUE(drawn_with(points, false).starts_with("with points pointtype 6"));
}

// A summary from an untrusted source must not inject commands.
TEST(Panel, ALookThatIsNoneRunsNothing) {
  EXPECT_EQ(drawn_with({.colour = "x'; system('rm')\n#", .dash = "solid; system('rm')", .width = 1},
                       false),
            "with lines linewidth 1 dashtype solid linecolor rgb 'x''; system(''rm'') #'");
}

TEST(Panel, NamesABlockForEachCurveWhateverTheIds) {
  auto one = made_up_case();
  for (auto& solution : one.solutions) {
    for (auto& curve : one.curves) {
      if (curve.solution == solution.id() && solution.id() == "fd-kf") curve.solution = "fd.km4";
    }
    if (solution.id() == "fd-kf") solution.identity.id = "fd.km4";
  }
  std::set<std::string> names;
  const auto content = figure_content(one);
  for (const auto& side : content.sides) {
    for (const auto& drawn : side.curves) {
      const std::string name = block_name(side, drawn);
      EXPECT_TRUE(names.insert(name).second) << name;
      EXPECT_TRUE(name.starts_with("$y")) << name;
      EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", 1),
                std::string::npos)
          << name;
    }
  }
}

TEST(Panel, HasTitleAxesAndEveryCurve) {
  const auto one = made_up_case();
  const auto content = figure_content(one);
  const auto& side = content.sides[1];
  const std::string linear = panel_commands(Panel::linear, side, 'c', content.reference);
  const std::string logarithmic = panel_commands(Panel::logarithmic, side, 'd', content.reference);
  const std::string difference = panel_commands(Panel::difference, side, 'f', content.reference);
  EXPECT_TRUE(contains(linear, "set title '(c) velocity'\n")) << linear;
  EXPECT_TRUE(contains(logarithmic, "set title '(d) velocity, logarithmic'\n")) << logarithmic;
  EXPECT_TRUE(contains(difference, "set title '(f) velocity, difference from mcs'\n"));
  EXPECT_FALSE(contains(linear, "logscale y"));
  EXPECT_TRUE(contains(logarithmic, "set logscale y"));
  for (const auto& drawn : side.curves) {
    for (const auto* text : {&linear, &logarithmic}) {
      EXPECT_TRUE(contains(*text, block_name(side, drawn) + ' ')) << *text;
    }
    EXPECT_TRUE(contains(difference, difference_block_name(side, drawn) + ' ')) << difference;
  }
}

}  // namespace
}  // namespace fpkcheck::report
