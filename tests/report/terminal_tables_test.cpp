#include "report/terminal_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "modified_case.hpp"
#include "report/findings.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::collapse_whitespace;
using tests::contains;
using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;

std::string table_of(const results::CaseResult& case_result,
                     const TerminalTextFormat& format = {}) {
  return terminal_tables_text({results::current_program("fpkcheck run"), {case_result}}, format);
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

std::vector<std::string> cells_of(const std::string& text, const std::string& start) {
  std::istringstream row(line_starting(text, start));
  std::vector<std::string> cells;
  for (std::string cell; row >> cell;) cells.push_back(cell);
  return cells;
}

// The two header lines above the rows of solutions.
std::string headers_of(const std::string& text) {
  const auto all = lines(text);
  const auto below =
      std::ranges::find_if(all, [](const auto& line) { return line.starts_with("solution"); });
  return *(below - 1) + *below;
}

class TableWidth : public testing::TestWithParam<std::size_t> {};

TEST_P(TableWidth, IsKeptAndEverySolutionIsShownWithItsStatus) {
  const std::string text = table_of(made_up_case(), GetParam());
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
  const std::string wide = table_of(made_up_case(), 100), narrow = table_of(made_up_case(), 80);
  for (const char* header : {"solves", "E[y^2]", "E[y'^2]", "L1 to fd-kf", "energy", "sec"}) {
    EXPECT_TRUE(contains(headers_of(wide), header)) << header;
  }
  EXPECT_TRUE(contains(headers_of(narrow), "E[y'^2]"));
  EXPECT_FALSE(contains(headers_of(narrow), "L1 to fd-kf"));
  EXPECT_FALSE(contains(wide, "Omitted"));
  EXPECT_TRUE(contains(collapse_whitespace(narrow),
                       "Omitted at 80 characters per line: L1 to fd-kf, energy. A wider"));
}

TEST(Table, PutsEachNumberUnderItsHeader) {
  auto case_result = made_up_case();
  set_l1(case_result, "fd-km4", "mcs", 0.01111, 0.02222);
  set_l1(case_result, "fd-km4", "fd-kf", 0.03333, 0.04444);
  auto& solution = solution_of(case_result, "fd-km4");
  solution.moments.y2 = 0.5551;
  solution.moments.v2 = 0.6661;
  solution.energy_residual = -7e-4;
  solution.seconds = 8.88;
  const std::vector<std::string> expected{"fd-km4",  "km4/map", "ok",      "0.5551",
                                          "0.6661",  "0.01111", "0.02222", "0.03333",
                                          "0.04444", "-7e-04",  "8.88"};
  EXPECT_EQ(cells_of(table_of(case_result, 100), "fd-km4"), expected);
}

TEST(Table, PutsTheReferenceFirstAndKeepsItWhereThereIsLittleRoom) {
  auto case_result = made_up_case();
  const auto before = table_of(case_result, 100);
  EXPECT_LT(before.find("L1 to mcs"), before.find("L1 to fd-kf"));
  solution_of(case_result, "fd-kf").error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  case_result.update_assessment();
  const auto after = table_of(case_result, 100);
  EXPECT_LT(after.find("L1 to fd-kf"), after.find("L1 to mcs"));
  EXPECT_TRUE(contains(headers_of(table_of(case_result, 80)), "L1 to fd-kf"));
  EXPECT_FALSE(contains(headers_of(table_of(case_result, 80)), "L1 to mcs"));
}

TEST(Table, ADistanceIsTheSameFromBothSides) {
  auto case_result = made_up_case();
  set_l1(case_result, "fd-kf", "mcs", 0.01234, 0.05678);
  const std::string text = table_of(case_result, 100);
  for (const char* id : {"fd-kf", "mcs"}) {
    EXPECT_TRUE(contains(line_starting(text, id), "0.01234 0.05678")) << text;
  }
}

TEST(Table, ShowsADashForWhatIsAbsentAndNoColumnOfDashes) {
  EXPECT_EQ(cells_of(table_of(made_up_case(), 100), "epc-gaussian-n8")[3], "-");
  auto case_result = made_up_case();
  solution_of(case_result, "fd-km4").moments.y2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cells_of(table_of(case_result, 100), "fd-km4")[3], "-");

  const std::string without_simulation = table_of(tests::case_with_first(7), 100);
  EXPECT_FALSE(contains(without_simulation, "L1 to mcs"));
  EXPECT_TRUE(contains(without_simulation, "L1 to fd-kf"));
  EXPECT_FALSE(contains(table_of(tests::case_with_first(4), 100), "L1 to"));
}

TEST(Table, GivesTheParametersAndTheReasons) {
  const std::string text = table_of(made_up_case(), 100);
  EXPECT_TRUE(contains(text, "case1: c = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses"));
  EXPECT_TRUE(contains(text, "epc-gaussian-n8 not_converged: the residual stopped falling"));
  EXPECT_TRUE(contains(text, "epc-gaussian-n4 inadmissible: the leading form"));
  EXPECT_FALSE(contains(text, "fd-kf ok:"));
}

TEST(Table, HasTheErrorBudgetAndTheFindings) {
  const auto case_result = made_up_case();
  const std::string text = collapse_whitespace(table_of(case_result, 100));
  EXPECT_TRUE(contains(text, "error budget total"));
  for (const auto& sentence : case_finding_sentences(case_result))
    EXPECT_TRUE(contains(text, sentence)) << sentence;
}

TEST(Table, OfSeveralCasesExplainsItsColumnsOnce) {
  const auto run =
      results::Run{results::current_program(""), {made_up_case("a"), made_up_case("b")}};
  const std::string text = terminal_tables_text(run);
  EXPECT_TRUE(contains(text, "\na: c = ") || text.starts_with("a: c = "));
  EXPECT_TRUE(contains(text, "\nb: c = "));
  EXPECT_EQ(text.find("L1: integral"), text.rfind("L1: integral"));
}

}  // namespace
}  // namespace fpkcheck::report
