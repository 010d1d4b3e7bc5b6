#include "base/files/file_transaction.hpp"
#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "made_up_page.hpp"
#include "results/run.hpp"
#include "results/saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_run;
using tests::occurrences;
using tests::plots_in;
using tests::solution_of;
using tests::whole_run;

TEST(Page, HasTheSectionsOfAWholeRun) {
  const auto run = whole_run();
  const std::string html = report_page_html(run);
  for (const char* heading :
       {"<section id=\"verdict\">", "<h2>The problem</h2>", "<h2>case1 <small>c = 0.1",
        ">Densities and differences</h3>", ">Results</h3>", ">Error budget</h3>",
        ">Convergence</h3>", "<summary>Joint densities</summary>",
        "<summary>L1 distance against computing time</summary>", "<summary>Diagnostics</summary>",
        "<h2>Timings and command</h2>"}) {
    EXPECT_EQ(occurrences(html, heading), 1u) << heading;
  }
  // The answer precedes the problem, the problem the cases.
  EXPECT_LT(html.find("class=\"answer\""), html.find("<h2>The problem"));
  EXPECT_LT(html.find("class=\"strip\""), html.find("<h2>The problem"));
  EXPECT_LT(html.find("<h2>The problem"), html.find("<h2>case1"));
  EXPECT_TRUE(contains(html, "<code>fpkcheck run</code>"));
  EXPECT_TRUE(contains(html, "<small>c = 0.1, k = 1, \u03bc = 0.1, r = 0.98; gaussian impulses"));
  EXPECT_TRUE(contains(html, "epc-gaussian-n8 not_converged</strong>: the residual stopped"));
  EXPECT_TRUE(contains(html, "<li>" + results::limiting_errors_text(run.cases[0]).substr(0, 30)));
  EXPECT_TRUE(contains(html, "The total is at most the sum of the parts"));
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_FALSE(contains(html, "{{body"));
}

TEST(Page, StatesTheReferenceOnce) {
  const std::string html = report_page_html(whole_run());
  EXPECT_EQ(occurrences(html, "Reference: fd-kf, the solution with the smallest"), 1u);
}

TEST(Page, IsSelfContained) {
  const std::string html = report_page_html(whole_run());
  for (const char* fetched : {"src=", "<link", "@import", "url(http", "href=\"http"}) {
    EXPECT_FALSE(contains(html, fetched)) << fetched;
  }
  EXPECT_TRUE(contains(html, "default-src 'none'"));
}

TEST(Page, ShowsNamesLiterally) {
  const std::string hostile = "</script><script>alert(1)</script>&amp;\"'";
  auto run = whole_run(hostile);
  run.program.command = "fpkcheck run '" + hostile + "'";
  auto& case_result = run.cases[0];
  for (auto& solution : case_result.solutions) {
    solution.identity.family += hostile;
    solution.identity.meaning = hostile;
    solution.reason = "because 1 < 2 " + hostile;
    solution.metrics =
        transform::SolverMetricsBuilder().add_text_metric(hostile, hostile).take_metrics();
  }
  // Renames a solution wherever its id occurs.
  const std::string old = "epc-gaussian-n6", renamed = "n6" + hostile;
  const auto rename = [&](std::string& id) { id = id == old ? renamed : id; };
  rename(solution_of(case_result, old).identity.id);
  for (auto& pair : case_result.pairs) rename(pair.a);
  for (auto& row : case_result.budget) rename(row.solution);
  for (auto& curve : case_result.curves) rename(curve.solution);
  for (auto& joint : case_result.joints) rename(joint.solution);
  case_result.update_assessment();
  const std::string html = report_page_html(run);
  EXPECT_EQ(occurrences(html, "<script"), 3u);
  EXPECT_EQ(occurrences(html, "</script>"), 3u);
  EXPECT_FALSE(contains(html, "alert(1)</"));
  EXPECT_TRUE(contains(html,
                       "<h2>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;amp;"
                       "&quot;&#39; <small>"));
  // plotly.js interprets names as a subset of HTML.
  bool found = false;
  const auto plots = plots_in(html);
  for (const auto& trace : plots.at(0).at("plots").at(0).at("figure").at("data")) {
    if (trace.at("legendgroup") != renamed) continue;
    found = true;
    EXPECT_EQ(trace.at("name"), "n6&lt;/script>&lt;script>alert(1)&lt;/script>&amp;amp;\"'");
  }
  EXPECT_TRUE(found);
}

TEST(Page, OfAnOlderRunLeavesOutWhatWasNotSaved) {
  auto run = made_up_run();
  run.cases[0].joints.clear();
  run.cases[0].budget.clear();
  run.cases[0].update_assessment();
  const std::string html = report_page_html(run);
  EXPECT_FALSE(contains(html, "Joint densities"));
  EXPECT_FALSE(contains(html, ">Error budget</h3>"));
  EXPECT_TRUE(plots_in(html).at(0).at("maps").is_null());
  EXPECT_TRUE(contains(html, ">Densities and differences</h3>"));
}

TEST(Page, ShowsDashesWithoutAnyDensity) {
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  auto run = made_up_run();
  auto& case_result = run.cases[0];
  case_result.curves.clear();
  case_result.joints.clear();
  case_result.pairs.clear();
  case_result.budget.clear();
  for (auto& solution : case_result.solutions) {
    solution.status = transform::Status::failed;
    solution.density.reset();
    solution.estimated_marginals.clear();
    solution.seconds = kNotANumber;
    solution.moments.y2 = kNotANumber;
  }
  case_result.update_assessment();
  const std::string html = report_page_html(run);
  EXPECT_FALSE(contains(html, ">Densities and differences</h3>"));
  EXPECT_FALSE(contains(html, ">Convergence</h3>"));
  EXPECT_TRUE(contains(html, "fd-kf failed</strong>"));
  EXPECT_FALSE(contains(html, ">nan<"));
  EXPECT_TRUE(plots_in(html).at(0).at("plots").empty());
}

TEST(Page, StatesThatThereIsNoReference) {
  auto run = made_up_run();
  for (auto& solution : run.cases[0].solutions) {
    if (solution.identity.role == transform::SolutionRole::closure) continue;
    solution.status = transform::Status::failed;
  }
  run.cases[0].update_assessment();
  const std::string html = report_page_html(run);
  EXPECT_TRUE(
      contains(html, "<p class=\"answer\">There is no reference: no solution of the full problem"));
  EXPECT_TRUE(contains(html, "<p>There is no reference"));
}

TEST(Page, LeadsToEveryPartOfEveryCase) {
  auto run = whole_run();
  for (int k = 2; k <= 50; ++k) run.cases.push_back(run.cases[0]);
  const std::string html = report_page_html(run);
  // Direct links for a few cases only; the menu has all.
  EXPECT_EQ(occurrences(html, "<a href=\"#case-50\">"), 2u);  // menu, matrix
  for (auto at = html.find("<a href=\"#"); at != std::string::npos;
       at = html.find("<a href=\"#", at + 1)) {
    const auto begin = at + std::string("<a href=\"#").size();
    const std::string anchor = html.substr(begin, html.find('"', begin) - begin);
    EXPECT_EQ(occurrences(html, " id=\"" + anchor + "\""), 1u) << anchor;
  }
}

TEST(Page, MentionsCirclesOnlyWithASimulation) {
  auto run = made_up_run();
  EXPECT_TRUE(contains(report_page_html(run), "Circles in a grey band"));
  solution_of(run.cases[0], "mcs").status = transform::Status::failed;
  run.cases[0].update_assessment();
  EXPECT_FALSE(contains(report_page_html(run), "Circles in a grey band"));
}

TEST(Page, OfASavedRunIsThatOfTheRun) {
  auto run = whole_run();
  for (auto& solution : run.cases[0].solutions) {
    solution.metrics = transform::SolverMetricsBuilder()
                           .add_diagnostic_metric("steps", std::int64_t{3})
                           .add_result_metric("tail.kind", std::string("confined"))
                           .add_result_metric("last", 1e7)
                           .take_metrics();
    solution.options = {{"order", std::int64_t{6}}};
  }
  // Files store this metric beside the error estimate, before all other metrics.
  solution_of(run.cases[0], "fd-kf")
      .metrics.push_back({.path = "error.observed_order", .value = 5.25});
  // Single precision, as in the files of a run.
  for (double& p : run.cases[0].joints.back().density.averages) p = static_cast<float>(p);
  const tests::TemporaryDirectory directory;
  base::FileTransaction files;
  results::add_run_files(files, directory.path(), run);
  files.commit();
  EXPECT_TRUE(report_page_html(results::load_run(directory.path())) == report_page_html(run));
}

TEST(Page, StatesFirstThatTheRunWasStopped) {
  auto run = whole_run();
  EXPECT_FALSE(contains(report_page_html(run), "was stopped"));
  run.stopped = "This run was stopped. Missing: <b>.";
  EXPECT_TRUE(
      contains(report_page_html(run),
               "</h1>\n<p><strong>This run was stopped. Missing: &lt;b&gt;.</strong>\n</p>"));
}

TEST(Page, OfFourCasesAndFifteenSolutionsStaysUnderAMegabyteEach) {
  // More closures, up to fifteen solutions.
  auto case_result = whole_run().cases[0];
  for (int n = 10; n < 24; n += 2) {
    const std::string id = "epc-moment-n" + std::to_string(n);
    auto closure = solution_of(case_result, "epc-gaussian-n6");
    closure.identity.id = id;
    case_result.solutions.insert(case_result.solutions.begin(), closure);
    auto joint = case_result.joints.front();
    joint.solution = id;
    case_result.joints.push_back(joint);
    for (const auto variable : transform::kVariables) {
      auto curve = *case_result.marginal_curve("epc-gaussian-n6", variable);
      curve.solution = id;
      case_result.curves.push_back(curve);
    }
  }
  case_result.update_assessment();
  ASSERT_EQ(case_result.solutions.size(), 15u);
  EXPECT_LT(report_page_html({results::current_program("fpkcheck run"), {case_result}}).size(),
            1'000'000u);
  results::Run run{results::current_program("fpkcheck run"), {}};
  for (int c = 0; c < 4; ++c) {
    run.cases.push_back(case_result);
    run.cases.back().problem.name = "case" + std::to_string(c);
  }
  EXPECT_LT(report_page_html(run).size(), 1'600'000u);
}

}  // namespace
}  // namespace fpkcheck::report
