#include "compare/page/page.hpp"

#include <gtest/gtest.h>

#include <set>

#include "made_up_page.hpp"

namespace fpkcheck::compare {
namespace {

using tests::contains;
using tests::made_up_run;
using tests::occurrences;
using tests::plots_in;
using tests::whole_run;
using Json = nlohmann::json;

Json traces_of(const std::string& page, const std::string& plot) {
  const Json plots = plots_in(page);
  for (const auto& one : plots.at(0).at("plots")) {
    if (one.at("id") == plot) return one.at("figure").at("data");
  }
  return Json::array();
}

TEST(Page, HasTheSectionsOfAWholeRun) {
  const std::string page = report_page(whole_run());
  for (const char* heading :
       {"<h2>The problem</h2>", "<h2>case1</h2>", "<h3>Results</h3>", "<h3>Densities</h3>",
        "<h3>Joint densities</h3>", "<h3>Error budget</h3>", "<h3>Convergence</h3>",
        "<h3>Distance against cost</h3>", "<h3>Diagnostics</h3>",
        "<h2>Timings, and how to repeat this</h2>"}) {
    EXPECT_EQ(occurrences(page, heading), 1u) << heading;
  }
  EXPECT_TRUE(contains(page, "<code>fpkcheck run</code>"));
  EXPECT_TRUE(contains(page, "Damping c = 0.1, stiffness k = 1, cubic stiffness \u03bc = 0.1"));
  EXPECT_TRUE(contains(page, "epc-gaussian-n8 not_converged</strong>: the residual stopped"));
  EXPECT_TRUE(contains(page, "<li>Nothing here is exact.</li>"));
  EXPECT_TRUE(contains(page, "<li>Replacing the impulses by white noise costs L1"));
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_FALSE(contains(page, "{{body"));
}

TEST(Page, IsSelfContained) {
  const std::string page = report_page(whole_run());
  for (const char* fetched : {"src=", "<link", "@import", "url(http", "href=\"http"}) {
    // Of the page's own parts; the library's script says such words without doing them.
    const auto script = page.find("* plotly.js");
    ASSERT_NE(script, std::string::npos);
    EXPECT_FALSE(contains(page.substr(0, script), fetched)) << fetched;
  }
  EXPECT_TRUE(contains(page, "default-src 'none'"));
}

TEST(Page, ShowsNamesLetterByLetter) {
  const std::string hostile = "</script><script>alert(1)</script>&amp;\"'";
  auto run = whole_run(hostile);
  run.summary["program"]["command"] = "fpkcheck run '" + hostile + "'";
  run.summary["cases"][0]["solutions"][3]["reason"] = "because 1 < 2 " + hostile;
  run.summary["cases"][0]["budget"][0]["parts"][0]["name"] = hostile;
  const std::string page = report_page(run);
  EXPECT_EQ(occurrences(page, "<script"), 3u);
  EXPECT_EQ(occurrences(page, "</script>"), 3u);
  EXPECT_FALSE(contains(page, "alert(1)</"));
  EXPECT_TRUE(contains(page,
                       "<h2>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;amp;"
                       "&quot;&#39;</h2>"));
  EXPECT_EQ(plots_in(page).at(0).at("plots").at(2).at("figure").at("data").at(0).at("name"),
            hostile);
}

TEST(Page, DrawsEverySolutionThatHasADensity) {
  const std::string page = report_page(made_up_run());
  for (const std::string plot : {"case-1-density-y", "case-1-density-ydot"}) {
    std::map<std::string, int> rows;  // curves, by solution
    std::set<std::string> shown;
    for (const auto& trace : traces_of(page, plot)) {
      const auto id = trace.at("legendgroup").get<std::string>();
      if (trace.value("fill", "").empty() && trace.value("hoverinfo", "") != "skip") ++rows[id];
      if (trace.value("visible", "") != "legendonly") shown.insert(id);
    }
    const std::map<std::string, int> expected{{"epc-gaussian-n2", 3},
                                              {"epc-gaussian-n4", 3},
                                              {"epc-gaussian-n6", 3},
                                              {"fd-white", 3},
                                              {"fd-km4", 3},
                                              {"fd-kf", 3},
                                              {"mcs", 3}};
    EXPECT_EQ(rows, expected) << plot;
    EXPECT_EQ(shown, (std::set<std::string>{"epc-gaussian-n6", "fd-kf", "mcs"})) << plot;
  }
}

TEST(Page, NamesThatAreNotOkSayTheirStatus) {
  const std::string page = report_page(made_up_run());
  std::set<std::string> names;
  for (const auto& trace : traces_of(page, "case-1-density-y")) names.insert(trace.at("name"));
  EXPECT_TRUE(names.contains("epc-gaussian-n4 (inadmissible)"));
  EXPECT_TRUE(names.contains("epc-gaussian-n6"));
}

TEST(Page, OfAnOlderRunLeavesOutWhatWasNotSaved) {
  auto run = made_up_run();
  run.joints.clear();
  run.summary["cases"][0]["budget"] = nlohmann::ordered_json::array();
  const std::string page = report_page(run);
  EXPECT_FALSE(contains(page, "Joint densities"));
  EXPECT_FALSE(contains(page, "Error budget"));
  EXPECT_TRUE(plots_in(page).at(0).at("maps").is_null());
  EXPECT_TRUE(contains(page, "<h3>Densities</h3>"));
}

TEST(Page, SaysADashForNullAndIsMadeWithoutAnyDensity) {
  auto run = made_up_run();
  run.marginals.clear();
  run.joints.clear();
  auto& summary_case = run.summary["cases"][0];
  summary_case["comparisons"] = nlohmann::ordered_json::array();
  summary_case["budget"] = nlohmann::ordered_json::array();
  for (auto& solution : summary_case["solutions"]) {
    solution["status"] = "failed";
    solution["moments"] = nullptr;
    solution["seconds"] = nullptr;
    solution["mass"] = nullptr;
    solution["min_density"] = nullptr;
    solution["energy_residual"] = nullptr;
    solution["support"] = nullptr;
  }
  const std::string page = report_page(run);
  EXPECT_FALSE(contains(page, "<h3>Densities</h3>"));
  EXPECT_FALSE(contains(page, "<h3>Convergence</h3>"));
  EXPECT_TRUE(contains(page, "fd-kf failed</strong>"));
  EXPECT_FALSE(contains(page, ">nan<"));
  EXPECT_TRUE(plots_in(page).at(0).at("plots").empty());
}

TEST(Page, NamesNoClosestClosureWithoutAReference) {
  auto run = made_up_run();
  EXPECT_TRUE(contains(report_page(run), "closest closure"));
  for (auto& solution : run.summary["cases"][0]["solutions"]) {
    if (solution["method"] != "epc") solution["status"] = "failed";
  }
  EXPECT_FALSE(contains(report_page(run), "closest closure"));
}

TEST(Page, SpeaksOfCirclesOnlyWithASimulation) {
  auto run = made_up_run();
  EXPECT_TRUE(contains(report_page(run), "Circles in a grey band"));
  for (auto& solution : run.summary["cases"][0]["solutions"]) {
    if (solution["id"] == "mcs") solution["status"] = "failed";
  }
  EXPECT_FALSE(contains(report_page(run), "Circles in a grey band"));
}

TEST(Page, ExplainsTheBudgetAndEveryName) {
  const std::string page = report_page(whole_run());
  EXPECT_TRUE(contains(page, "The total is at most the sum of the parts"));
  for (const char* term : {"closure", "impact", "truncation", "white noise", "discretisation",
                           "sampling", "fd-km4-delta", "given / \u2013"}) {
    EXPECT_EQ(occurrences(page, "<dt>" + std::string(term) + "</dt>"), 1u) << term;
  }
}

TEST(Page, OfFourCasesAndFifteenSolutionsStaysUnderThreeMegabytes) {
  const auto report = tests::full_report();
  const auto joints = tests::made_up_joints(report, 70, 140);
  auto run = made_up_run();
  const auto one_case = run.summary["cases"][0];
  const auto marginals = run.marginals;
  run.summary["cases"].clear();
  run.marginals.clear();
  run.joints.clear();
  for (int c = 0; c < 4; ++c) {
    auto more = one_case;
    more["name"] = "case" + std::to_string(c);
    for (auto joint : joints) {
      joint.case_name = more["name"];
      run.joints.push_back(joint);
    }
    for (auto curve : marginals) {
      curve.case_name = more["name"];
      run.marginals.push_back(curve);
    }
    // More closures, up to fifteen solutions.
    for (int n = 10; n < 24; n += 2) {
      auto closure = one_case["solutions"][2];
      closure["id"] = "epc-moment-n" + std::to_string(n);
      more["solutions"].insert(more["solutions"].begin(), closure);
      auto joint = joints.front();
      joint.case_name = more["name"];
      joint.solution = closure["id"];
      run.joints.push_back(joint);
      for (auto curve : marginals) {
        if (curve.solution != "epc-gaussian-n6") continue;
        curve.case_name = more["name"];
        curve.solution = closure["id"];
        run.marginals.push_back(curve);
      }
    }
    run.summary["cases"].push_back(more);
  }
  ASSERT_EQ(run.summary["cases"][0]["solutions"].size(), 15u);
  EXPECT_LT(report_page(run).size(), 3'000'000u);
}

}  // namespace
}  // namespace fpkcheck::compare
