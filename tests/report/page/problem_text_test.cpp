#include "report/page/page_sections.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::headers_in;
using tests::occurrences;
using tests::row_in;
using tests::solution_of;
using tests::whole_run;

TEST(ProblemText, ListsCommonParametersOnceAndTheRestInATable) {
  auto run = whole_run();
  run.cases.push_back(run.cases[0]);
  run.cases[1].problem = tests::make_problem({.cubic = 0.25, .mean = 0.125, .law = "laplace"});
  run.cases[1].problem.name = "<other>";
  const std::string html = problem_description_html(run);
  const std::string caption = "Parameters that differ between cases";
  EXPECT_EQ(headers_in(html, caption), "parameter|case1|&lt;other&gt;");
  EXPECT_EQ(row_in(html, caption, "\u03bc, cubic stiffness"), "0.1|0.25");
  EXPECT_EQ(row_in(html, caption, "law of the amplitudes"), "gaussian|laplace");
  EXPECT_EQ(row_in(html, caption, "E[Y], mean amplitude"), "0|0.125");
  EXPECT_TRUE(
      contains(html, "<p>Parameters of all cases: c, damping = 0.1; k, stiffness = 1; r, "));
  // Every parameter is in the sentence or in the table.
  const std::string shared = html.substr(html.find("<p>Parameters of all cases"));
  EXPECT_EQ(occurrences(html, "<th scope=\"row\">") +
                occurrences(shared.substr(0, shared.find("</p>")), " = "),
            problem::parameters_for_reports(run.cases[0].problem).size());
  EXPECT_EQ(varying_parameters_text(run, run.cases[1]),
            "\u03bc = 0.25, law of the amplitudes = laplace, E[Y] = 0.125");
}

TEST(ProblemText, OfOneCaseHasNoTable) {
  const auto run = whole_run();
  EXPECT_FALSE(contains(problem_description_html(run), "<table"));
  EXPECT_TRUE(contains(problem_description_html(run), "<p>Parameters: c, damping = 0.1; "));
  EXPECT_EQ(varying_parameters_text(run, run.cases[0]), "");
}

TEST(Glossary, ExplainsTheNamesOfThisRunFromTheirTables) {
  auto run = whole_run();
  solution_of(run.cases[0], "fd-white").identity.family = "toy";
  solution_of(run.cases[0], "fd-white").identity.meaning = "What 1 < 2 toys make.";
  const std::string html = glossary_html(run);
  EXPECT_TRUE(contains(html, "<dt>fd-white</dt><dd>What 1 &lt; 2 toys make.</dd>"));
  EXPECT_TRUE(contains(html, "<dt>fd-km4, fd-kf</dt><dd>What fd makes.</dd>"));
  EXPECT_TRUE(contains(html, "<dt>solves white/\u2026</dt><dd>Excitation: white noise.</dd>"));
  EXPECT_TRUE(contains(html, "<dt>solves \u2026/delta</dt>"));
  EXPECT_FALSE(contains(html, "km4-pade"));  // no solution has this equation
  EXPECT_FALSE(contains(html, "given/-"));
  for (const auto& status : transform::kStatusNames) {
    EXPECT_TRUE(contains(html, fmt::format("<b>{}</b>", status.name)));
  }
  for (const auto& link : compare::kApproximationNames) {
    EXPECT_EQ(occurrences(html, fmt::format("<dt>{}</dt>", link.name)), 1u) << link.name;
  }
}

TEST(Glossary, StatesUnknownEquationAndImpact) {
  auto run = whole_run();
  auto& identity = solution_of(run.cases[0], "fd-white").identity;
  identity.equation.reset();
  identity.impact.reset();
  EXPECT_TRUE(contains(glossary_html(run), "<dt>solves given/-</dt>"));
}

TEST(Timings, AreThoseOfEachSolutionAndAllTogether) {
  auto run = whole_run();
  run.cases.push_back(run.cases[0]);
  run.cases[1].problem.name = "other";
  run.cases[1].solutions.erase(run.cases[1].solutions.begin() + 1, run.cases[1].solutions.end());
  run.cases[1].update_assessment();
  const std::string html = timings_table_html(run);
  EXPECT_EQ(headers_in(html, "Seconds per solution"), "solution|case1|other");
  EXPECT_EQ(row_in(html, "Seconds per solution", "epc-gaussian-n8"), "12.3|\u2013");
  EXPECT_EQ(row_in(html, "Seconds per solution", "all"), "15.2|0.42");
}

}  // namespace
}  // namespace fpkcheck::report
