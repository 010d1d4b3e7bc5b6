#include "report/figure/panel.hpp"

#include <gtest/gtest.h>

#include <set>

#include "modified_case.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;

TEST(Panel, UsesThePlotStyle) {
  EXPECT_EQ(curve_style({.colour = "#123456", .dash = "(10,4)", .width = 2.5}, false),
            "with lines linewidth 2.5 dashtype (10,4) linecolor rgb '#123456'");
  EXPECT_EQ(curve_style({}, true),
            "with lines linewidth 1.5 dashtype solid linecolor rgb '#777777'");
  const transform::PlotStyle points{.as_points = true};
  EXPECT_TRUE(curve_style(points, true).starts_with("with yerrorbars pointtype 6"));
  EXPECT_TRUE(curve_style(points, false).starts_with("with points pointtype 6"));
}

// A summary from an untrusted source must not inject commands.
TEST(Panel, RunsNoCommandOfAnInvalidStyle) {
  EXPECT_EQ(
      curve_style({.colour = "x'; system('rm')\n#", .dash = "solid; system('rm')", .width = 1},
                  false),
      "with lines linewidth 1 dashtype solid linecolor rgb 'x''; system(''rm'') #'");
}

TEST(Panel, HasUniqueValidBlockNames) {
  auto case_result = made_up_case();
  for (auto& solution : case_result.solutions) {
    for (auto& curve : case_result.curves) {
      if (curve.solution == solution.id() && solution.id() == "fd-kf") curve.solution = "fd.km4";
    }
    if (solution.id() == "fd-kf") solution.identity.id = "fd.km4";
  }
  std::set<std::string> names;
  const auto content = figure_content(case_result);
  for (const auto& marginal : content.marginals) {
    for (const auto& drawn : marginal.curves) {
      const std::string name = block_name(marginal, drawn);
      EXPECT_TRUE(names.insert(name).second) << name;
      EXPECT_TRUE(name.starts_with("$y")) << name;
      EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", 1),
                std::string::npos)
          << name;
    }
  }
}

TEST(Panel, HasTitleAxesAndEveryCurve) {
  const auto case_result = made_up_case();
  const auto content = figure_content(case_result);
  const auto& marginal = content.marginals[1];
  const std::string linear = panel_commands(Panel::linear, marginal, 'c', content.reference);
  const std::string logarithmic =
      panel_commands(Panel::logarithmic, marginal, 'd', content.reference);
  const std::string difference =
      panel_commands(Panel::difference, marginal, 'f', content.reference);
  EXPECT_TRUE(contains(linear, "set title '(c) velocity'\n")) << linear;
  EXPECT_TRUE(contains(logarithmic, "set title '(d) velocity, logarithmic'\n")) << logarithmic;
  EXPECT_TRUE(contains(difference, "set title '(f) velocity, difference from mcs'\n"));
  EXPECT_FALSE(contains(linear, "logscale y"));
  EXPECT_TRUE(contains(logarithmic, "set logscale y"));
  for (const auto& drawn : marginal.curves) {
    for (const auto* text : {&linear, &logarithmic}) {
      EXPECT_TRUE(contains(*text, block_name(marginal, drawn) + ' ')) << *text;
    }
    EXPECT_TRUE(contains(difference, difference_block_name(marginal, drawn) + ' ')) << difference;
  }
}

}  // namespace
}  // namespace fpkcheck::report
