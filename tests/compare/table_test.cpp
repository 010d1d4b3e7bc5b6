#include "compare/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "compare/findings.hpp"
#include "compare/summary.hpp"
#include "compare/text/wrapped.hpp"
#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

Json made_up_summary() {
  return summary("fpkcheck run", std::vector<CaseReport>{tests::full_report()});
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

std::string line_starting(const std::string& text, const std::string& start) {
  for (const auto& line : lines(text)) {
    if (line.starts_with(start)) return line;
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Sets the L1 distances of one pair.
void set_l1(Json& summary, const std::string& a, const std::string& b, double y, double ydot) {
  for (auto& comparison : summary["cases"][0]["comparisons"]) {
    if (comparison["a"] == a && comparison["b"] == b) {
      comparison["l1"] = comparison["variable"] == "y" ? y : ydot;
    }
  }
}

// Every name of an equation that a table can show is explained below it.
TEST(TableLegend, ExplainsEveryEquation) {
  for (const std::string equation : {"white", "km4", "km4-pade", "kf"}) {
    Json summary = made_up_summary();
    for (auto& solution : summary["cases"][0]["solutions"]) solution["equation"] = equation;
    EXPECT_TRUE(contains(table(summary), "(" + equation + ": ")) << table(summary);
  }
}

class TableWidth : public testing::TestWithParam<std::size_t> {};

TEST_P(TableWidth, IsKeptAndEverySolutionIsShownWithItsStatus) {
  const std::string text = table(made_up_summary(), GetParam());
  for (const auto& line : lines(text)) EXPECT_LE(line.size(), GetParam()) << line;
  const std::pair<const char*, const char*> expected[] = {
      {"epc-gaussian-n2", " ok "}, {"epc-gaussian-n4", " inadmissible "},
      {"epc-gaussian-n6", " ok "}, {"epc-gaussian-n8", " not_converged "},
      {"fd-white", " ok "},        {"fd-km4", " ok "},
      {"fd-kf", " ok "},           {"mcs", " ok "}};
  for (const auto& [id, status] : expected) {
    EXPECT_TRUE(contains(line_starting(text, id), status)) << id << "\n" << text;
  }
  EXPECT_TRUE(contains(text, "L1 to mcs"));
}

INSTANTIATE_TEST_SUITE_P(Table, TableWidth, testing::Values(60, 80, 100, 140));

TEST(Table, ShowsEveryColumnAt100AndTheImportantOnesAt80) {
  const std::string wide = table(made_up_summary(), 100), narrow = table(made_up_summary(), 80);
  for (const char* header : {"solves", "E[y^2]", "E[y'^2]", "L1 to fd-kf", "energy", "sec"}) {
    EXPECT_TRUE(contains(line_starting(wide, "solution") + lines(wide)[1], header)) << header;
  }
  EXPECT_TRUE(contains(narrow, "E[y'^2]"));
  EXPECT_FALSE(contains(narrow, "L1 to fd-kf"));
}

TEST(Table, PutsEachNumberUnderItsHeader) {
  Json json = made_up_summary();
  set_l1(json, "fd-km4", "mcs", 0.01111, 0.02222);
  set_l1(json, "fd-km4", "fd-kf", 0.03333, 0.04444);
  Json& solution = json["cases"][0]["solutions"][5];
  ASSERT_EQ(solution["id"], "fd-km4");
  solution["moments"]["y2"] = 0.5551;
  solution["moments"]["v2"] = 0.6661;
  solution["energy_residual"] = -7e-4;
  solution["seconds"] = 8.88;
  std::istringstream row(line_starting(table(json, 100), "fd-km4"));
  std::vector<std::string> cells;
  for (std::string cell; row >> cell;) cells.push_back(cell);
  const std::vector<std::string> expected{"fd-km4",  "km4/map", "ok",      "0.5551",
                                          "0.6661",  "0.01111", "0.02222", "0.03333",
                                          "0.04444", "-7e-04",  "8.88"};
  EXPECT_EQ(cells, expected);
}

TEST(Table, ADistanceIsTheSameFromBothSides) {
  Json json = made_up_summary();
  set_l1(json, "fd-kf", "mcs", 0.01234, 0.05678);
  const std::string text = table(json, 100);
  for (const char* id : {"fd-kf", "mcs"}) {
    EXPECT_TRUE(contains(line_starting(text, id), "0.01234 0.05678")) << text;
  }
}

TEST(Table, ShowsADashForWhatIsAbsentAndNoColumnOfDashes) {
  const std::string text = table(made_up_summary(), 100);
  std::istringstream row(line_starting(text, "epc-gaussian-n8"));
  std::string id, solves, status, y2;
  row >> id >> solves >> status >> y2;
  EXPECT_EQ(y2, "-");

  auto report = tests::full_report();
  report.entries.pop_back();
  report = report_on_case(report.problem, report.axes, report.entries);
  const std::string without_simulation = table(summary("", std::vector<CaseReport>{report}), 100);
  EXPECT_FALSE(contains(without_simulation, "L1 to mcs"));
  EXPECT_TRUE(contains(without_simulation, "L1 to fd-kf"));
}

TEST(Table, GivesTheParametersAndTheReasons) {
  const std::string text = table(made_up_summary(), 100);
  EXPECT_TRUE(contains(text, "case1: c = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses"));
  EXPECT_TRUE(contains(text, "epc-gaussian-n8 not_converged: the residual stopped falling"));
  EXPECT_TRUE(contains(text, "epc-gaussian-n4 inadmissible: the leading form"));
  EXPECT_FALSE(contains(text, "fd-kf ok:"));
}

TEST(Table, HasTheErrorBudgetWithTheSentenceThatWasSaved) {
  Json json = made_up_summary();
  json["cases"][0]["limits"] = "Nothing limits it.";
  Json& row = json["cases"][0]["budget"][5];
  ASSERT_EQ(row["solution"].get<std::string>() + row["variable"].get<std::string>(),
            "epc-gaussian-n6ydot");
  row["total"] = 0.01111;
  row["total_tail"] = 0.2222;
  row["parts"][0]["l1"] = 0.03333;
  row["parts"][1]["l1"] = 4.4e-6;
  const std::string text = table(json, 120);
  const auto shown = lines(text);
  const auto title = std::ranges::find_if(
      shown, [](const auto& line) { return line.starts_with("error budget"); });
  ASSERT_NE(title, shown.end()) << text;
  const auto cells_of = [&](const std::string& start) {
    const auto line =
        std::find_if(title, shown.end(), [&](const auto& each) { return each.starts_with(start); });
    std::istringstream in(*line);
    std::vector<std::string> cells;
    for (std::string cell; in >> cell;) cells.push_back(cell);
    return cells;
  };
  // Names, then total, closure + impact, truncation of p(y), of p(y'), and the tails.
  const auto n6 = cells_of("epc-gaussian-n6");
  ASSERT_EQ(n6.size(), 9u) << text;
  EXPECT_EQ((std::vector<std::string>{n6[4], n6[5], n6[6], n6[8]}),
            (std::vector<std::string>{"0.01111", "0.03333", "4e-06", "0.222"}));
  EXPECT_EQ(cells_of("epc-gaussian-n4")[0], "epc-gaussian-n4*");
  EXPECT_NE(std::find(title, shown.end(), "  Nothing limits it."), shown.end()) << text;

  json["cases"][0]["budget"] = Json::array();
  json["cases"][0].erase("limits");  // as in older summaries
  EXPECT_FALSE(contains(table(json, 100), "error budget"));
}

TEST(Table, ExplainsTheColumnsThatAreShownAndNoOther) {
  // The lines break anywhere.
  const auto words = [](const std::string& text) {
    std::string joined;
    std::istringstream in(text);
    for (std::string word; in >> word;) joined += word + ' ';
    return joined;
  };
  const Json json = made_up_summary();
  const std::string wide = words(table(json, 140)), narrow = words(table(json, 80));
  for (const char* part : {"L1: integral", "white: white noise", "energy: residual",
                           "sec: wall-clock", "its parts and of the row discretisation + sampling;",
                           "closure: against", "impact: to first order", "trunc.: the series",
                           "tail: mean", "*: the closure found no admissible density"}) {
    EXPECT_TRUE(contains(wide, part)) << part << "\n" << wide;
  }
  EXPECT_FALSE(contains(narrow, "energy: residual")) << narrow;
  EXPECT_FALSE(contains(narrow, "tail: mean")) << narrow;

  auto report = tests::full_report();
  report.entries.erase(report.entries.begin() + 1, report.entries.end());
  report = report_on_case(report.problem, report.axes, report.entries);
  const std::string one = words(table(summary("", std::vector<CaseReport>{report}), 100));
  EXPECT_TRUE(contains(one, "km4: Kramers-Moyal")) << one;
  for (const char* absent : {"L1", "reference", "error budget", "white noise", "kf:", "*"}) {
    EXPECT_FALSE(contains(one, absent)) << absent << "\n" << one;
  }
}

TEST(Findings, SayWhichApproximationCostsWhat) {
  Json json = made_up_summary();
  set_l1(json, "fd-white", "fd-kf", 0.011, 0.031);
  set_l1(json, "fd-km4", "fd-kf", 1e-4, 4e-4);
  set_l1(json, "epc-gaussian-n6", "mcs", 0.0024, 0.0047);
  set_l1(json, "epc-gaussian-n2", "mcs", 0.005, 0.0046);
  set_l1(json, "epc-gaussian-n4", "mcs", 0.0001, 0.0001);  // the closest, but inadmissible
  set_l1(json, "fd-kf", "mcs", 0.0012, 0.0016);
  const auto sentences = findings(json["cases"][0]);
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_EQ(
      sentences[0],
      "Replacing the impulses by white noise costs L1 0.011 in p(y) and 0.031 in p(y'); cutting "
      "the Kramers-Moyal series after the fourth derivative costs 0.0001 in p(y) and 0.0004 in "
      "p(y').");
  EXPECT_EQ(sentences[1],
            "The admissible closure closest to the simulation: epc-gaussian-n6 with L1 0.0024 in "
            "p(y) and 0.0047 in p(y').");
  EXPECT_EQ(
      sentences[2],
      "The full jump equation (fd-kf) and the simulation differ by 0.0012 in p(y) and 0.0016 in "
      "p(y'); the simulation's own sampling error is 0.0011 in p(y) and 0.0015 in p(y'), which "
      "explains the difference.");
  set_l1(json, "fd-kf", "mcs", 0.0012, 0.016);
  EXPECT_TRUE(contains(findings(json["cases"][0])[2], "does not explain"));
}

TEST(Findings, SayWhatIsKnownOfADiscretisationError) {
  Json json = made_up_summary();
  for (auto& solution : json["cases"][0]["solutions"]) {
    if (solution["id"] != "fd-kf") continue;
    solution["error"] = {
        {"y_l1", 2.8e-5}, {"ydot_l1", 2.5e-5}, {"moments", {{"y2", 1.3e-6}, {"v2", 2.4e-6}}}};
  }
  // The budget has them.
  EXPECT_FALSE(contains(findings(json["cases"][0])[0], "discretisation"));
  json["cases"][0]["budget"] = Json::array();
  EXPECT_EQ(findings(json["cases"][0])[0],
            "The discretisation error of fd-kf, estimated from two coarser grids: L1 2.8e-05 in "
            "p(y) and 2.5e-05 in p(y'), 1e-06 in E[y^2] and 2e-06 in E[y'^2].");
  for (auto& solution : json["cases"][0]["solutions"]) {
    if (solution["id"] != "fd-km4") continue;
    solution["error"] = {
        {"y_l1", 3e-5}, {"ydot_l1", 1e-5}, {"moments", {{"y2", 4e-6}, {"v2", 1e-6}}}};
  }
  EXPECT_EQ(findings(json["cases"][0])[0],
            "The discretisation errors of fd-km4, fd-kf, estimated from two coarser grids: at most "
            "L1 3e-05 in p(y) and 2.5e-05 in p(y'), 4e-06 in E[y^2] and 2e-06 in E[y'^2].");
}

TEST(Findings, NameTheClosestClosureOfEachFormulation) {
  Json json = made_up_summary();
  json["cases"][0]["solutions"][0]["formulation"] = "moment";
  const auto sentence = findings(json["cases"][0])[1];
  EXPECT_TRUE(contains(sentence, "epc-gaussian-n6")) << sentence;
  EXPECT_TRUE(contains(sentence, "epc-gaussian-n2")) << sentence;
}

TEST(Findings, UseOnlySolutionsThatAreThereAndOk) {
  Json json = made_up_summary();
  for (auto& solution : json["cases"][0]["solutions"]) {
    if (solution["method"] == "epc" || solution["id"] == "fd-white") solution["status"] = "failed";
    if (solution["id"] == "mcs") solution.erase("sampling_l1");
  }
  const auto sentences = findings(json["cases"][0]);
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_TRUE(sentences[0].starts_with("Cutting the Kramers-Moyal series")) << sentences[0];
  EXPECT_TRUE(contains(sentences[1], "No exponential-polynomial closure")) << sentences[1];
  EXPECT_FALSE(contains(sentences[2], "sampling")) << sentences[2];

  json["cases"][0]["solutions"] = Json::array();
  EXPECT_TRUE(findings(json["cases"][0]).empty());
}

TEST(WrappedText, BreaksBetweenWordsAndIndents) {
  EXPECT_EQ(wrapped("  one two three", 9, 4), "  one two\n    three\n");
  EXPECT_EQ(wrapped("exactly ten", 11), "exactly ten\n");
  EXPECT_EQ(wrapped("exactly ten", 10), "exactly\nten\n");
  EXPECT_EQ(wrapped("unbreakable", 4), "unbreakable\n");
}

}  // namespace
}  // namespace fpkcheck::compare
