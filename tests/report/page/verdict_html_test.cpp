#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include "made_up_page.hpp"
#include "report/verdict/verdict.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::occurrences;
using tests::set_l1;

results::Run two_cases() {
  auto run = tests::whole_run("a<b");
  run.cases.push_back(tests::whole_case("other"));
  set_l1(run.cases[0], "epc-gaussian-n6", "fd-kf", 0.0031, 0.0042);
  set_l1(run.cases[1], "epc-gaussian-n6", "fd-kf", 0.031, 0.0042);
  return run;
}

TEST(VerdictView, HasEverySentenceOfTheVerdict) {
  const auto run = two_cases();
  const std::string html = verdict_html(run, {"case-1", "case-2"});
  const auto run_verdict = make_run_verdict(run);
  EXPECT_EQ(occurrences(html, "<p class=\"answer\">"), run_verdict.answer.size());
  EXPECT_EQ(occurrences(html, "<dt class="), run_verdict.lines.size());
  EXPECT_TRUE(contains(html, "<dt class=\"no\">epc-gaussian-n6</dt><dd>reproduced in part"));
}

TEST(VerdictView, ColoursACellByItsAgreement) {
  const std::string html = verdict_html(two_cases(), {"case-1", "case-2"});
  EXPECT_TRUE(contains(html, "<a href=\"#case-1\">a&lt;b</a>"));
  EXPECT_TRUE(contains(html, "<td class=\"number is-close\" title=\"ok\">0.0031</td>"));
  EXPECT_TRUE(contains(html, "<td class=\"number is-off\" title=\"ok\">0.031</td>"));
  EXPECT_TRUE(contains(html, "title=\"the reference\">ref</td>"));
  EXPECT_TRUE(contains(html, "title=\"not_converged\">\u2013<sup>x</sup></td>"));
}

// The key has only colours that occur in the cells.
TEST(VerdictView, ExplainsTheColoursOfTheCells) {
  auto run = two_cases();
  const auto key = [&] {
    const std::string html = verdict_html(run, {"case-1", "case-2"});
    const auto begin = html.find("key\">");
    EXPECT_LT(html.find("class=\"matrix\""), begin);
    EXPECT_LT(begin, html.find("<dl class=\"lines\">"));
    return html.substr(begin, html.find("</p>", begin) - begin);
  };
  for (const char* colour : {"is-reference", "is-close", "is-off", "is-none"}) {
    EXPECT_EQ(occurrences(key(), std::string("class=\"") + colour), 1u) << colour;
  }
  for (auto& case_result : run.cases) {
    std::erase_if(case_result.solutions, [](const auto& s) { return !s.has_status_ok(); });
    case_result.update_assessment();
  }
  EXPECT_EQ(occurrences(key(), "is-none"), 0u);
}

TEST(DistancePlot, HasAMarkForEachDistanceOrAText) {
  const auto run = two_cases();
  const std::string svg = reference_distance_plot_svg(run, results::assess_run(run).rows);
  // Circles in both cases: n = 2 and 6, white, km4, the simulation. Crosses: n = 4, inadmissible.
  EXPECT_EQ(occurrences(svg, "<circle"), 10u);
  EXPECT_EQ(occurrences(svg, "class=\"cross\""), 2u);
  EXPECT_TRUE(contains(svg, ">not_converged</text>"));
  EXPECT_TRUE(contains(svg, ">the reference</text>"));
  EXPECT_TRUE(contains(svg, "<title>epc-gaussian-n6, a&lt;b: 0.0042</title>"));
}

TEST(DistancePlot, PutsMarksWhereTheirDecadeIs) {
  auto run = two_cases();
  run.cases.pop_back();
  for (const char* id : {"epc-gaussian-n2", "epc-gaussian-n4", "fd-white", "fd-km4", "mcs"}) {
    set_l1(run.cases[0], id, "fd-kf", 0.1, 0.1);
  }
  set_l1(run.cases[0], "epc-gaussian-n6", "fd-kf", 1e-3, 1e-4);
  const std::string svg = reference_distance_plot_svg(run, results::assess_run(run).rows);
  const auto x_of = [&](const std::string& title) {
    const auto circle = svg.rfind("cx=\"", svg.find(title));
    return std::stod(svg.substr(circle + 4));
  };
  // The axis extends from 1e-5, below the error estimate 3e-5 of the reference, to 0.1: four
  // decades.
  const double left = 132, right = 546;
  EXPECT_NEAR(x_of("epc-gaussian-n6, a"), (left + right) / 2, 0.1);
  EXPECT_NEAR(x_of("fd-white, a"), right, 0.1);
}

TEST(DistancePlot, IsNothingWithoutDistances) {
  const results::Run run{{}, {tests::case_with_first(4)}};
  EXPECT_EQ(reference_distance_plot_svg(run, results::assess_run(run).rows), "");
}

}  // namespace
}  // namespace fpkcheck::report
