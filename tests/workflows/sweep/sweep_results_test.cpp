#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "made_up_sweep.hpp"
#include "results/netcdf/reader.hpp"
#include "workflows/sweep/map/validity_map.hpp"
#include "workflows/sweep/report/sweep_tables.hpp"

namespace fpkcheck::sweep {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string groups_text(std::size_t point) {
  const auto [impulses, damping, cubic] =
      dimensionless_groups(tests::small_plan().problem_at_sweep_point(point));
  return fmt::format("{:.4g},{:.4g},{:.4g}", impulses, damping, cubic);
}

TEST(SweepCsv, HasARowForEachPointAndMethod) {
  const auto lines = lines_of(sweep_csv_text(tests::results_of(tests::small_plan())));
  ASSERT_EQ(lines.size(), 1 + 6 * 2);
  EXPECT_EQ(lines[0],
            "impulse.rate,system.restitution,solution,status,reason,y1,y2,y4,v1,v2,v4,l1_y,l1_ydot,"
            "reference,seconds,error_y,error_ydot,budget_y_closure_and_impact,"
            "budget_ydot_closure_and_impact,impulses_per_decay_time,damping_ratio,cubic_share,"
            "slope_y2_impulse.rate,slope_v2_impulse.rate,slope_error_y2_impulse.rate,"
            "slope_error_v2_impulse.rate");
  const std::string groups = groups_text(4);
  EXPECT_EQ(lines[9],
            "2,0.9,epc-gaussian-n2,ok,,0,4,0,0,8,0,0.05,0.02,fd-kf,5,,,0.3,0.4," + groups + ",,,,");
  EXPECT_EQ(lines[10],
            "2,0.9,fd-kf,ok,,0,4.1,0,0,8.2,0,,,fd-kf,5.1,,,,," + groups + ",0.5,1,0.01,0.02");
}

TEST(SweepCsv, QuotesReasonsAndHasEmptyCellsForNaN) {
  auto results = tests::results_of(tests::small_plan());
  results.points[0].methods[0].reason = "a \"b\", c";
  results.points[0].methods[0].status = transform::Status::inadmissible;
  results.points[0].methods[0].moments->y2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lines_of(sweep_csv_text(results))[1],
            "1,0.8,epc-gaussian-n2,inadmissible,\"a \"\"b\"\", c\",0,,0,0,0,0,0.01,0.02,fd-kf,1,,,"
            "0.3,0.4," +
                groups_text(0) + ",,,,");
}

results::NetCdfReader reader_of(const SweepResults& results) {
  return results::NetCdfReader(sweep_netcdf_bytes(results, "fpkcheck sweep"));
}

TEST(SweepNetCdf, OfAProductHasItsKeysAsDimensions) {
  auto results = tests::results_of(tests::small_plan());
  results.points.erase(results.points.begin() + 1);
  auto file = reader_of(results);
  EXPECT_EQ(file.dimension_names("y2"),
            (std::vector<std::string>{"impulse.rate", "system.restitution", "solution"}));
  EXPECT_EQ(file.dimension_lengths("y2"), (std::vector<std::size_t>{2, 3, 2}));
  EXPECT_EQ(file.read_values("system.restitution"), (std::vector<double>{0.8, 0.9, 1}));
  EXPECT_EQ(file.read_labels("solution"), (std::vector<std::string>{"epc-gaussian-n2", "fd-kf"}));
  const auto y2 = file.read_values("y2");
  EXPECT_EQ(y2[1 * 6 + 2 * 2 + 1], 5.1);  // rate 2, restitution 1, fd-kf: point 5
  EXPECT_TRUE(std::isnan(y2[2]));         // point 1 is not there
  EXPECT_EQ(file.read_values("slope_v2_impulse.rate")[1 * 6 + 2 * 2 + 1], 0.25 * 5);
  EXPECT_TRUE(std::isnan(file.read_values("slope_v2_impulse.rate")[1 * 6 + 2 * 2]));
  const auto status = file.read_values("status");
  EXPECT_EQ(status[2], -1);
  EXPECT_EQ(status[0], 0);
  EXPECT_EQ(file.read_values("l1_y")[0], 0.01);
  EXPECT_EQ(file.read_values("reference")[0], 1);
  EXPECT_EQ(file.read_values("budget_closure___impact_ydot")[0], 0.4);
}

TEST(SweepNetCdf, OfAListHasItsPointsAndWords) {
  const SweepPlan plan = tests::plan_of({parse_sweep_axis("impulse.law", "gaussian,laplace", "x"),
                                         parse_sweep_axis("system.cubic", "1,2", "x")},
                                        SweepPlanDesign::list);
  auto file = reader_of(tests::results_of(plan));
  EXPECT_EQ(file.dimension_names("v2"), (std::vector<std::string>{"point", "solution"}));
  EXPECT_EQ(file.read_labels("impulse.law"), (std::vector<std::string>{"gaussian", "laplace"}));
  EXPECT_EQ(file.read_values("system.cubic"), (std::vector<double>{1, 2}));
}

TEST(SweepTable, CountsStatusesAndRanksDistancesOfOkSolutions) {
  auto results = tests::results_of(tests::small_plan());
  results.points[5].methods[0].status = transform::Status::inaccurate;  // the worst, 0.06
  const std::string text = sweep_table_text(results, {100, false});
  EXPECT_NE(text.find("6 points of test, impulse.rate = 1,2, system.restitution = 0.8:1:3"),
            std::string::npos);
  // 0.02, 0.02, 0.03, 0.04, 0.05 are ok: the larger value of both marginals.
  EXPECT_NE(text.find("epc-gaussian-n2   5          0    0.03  0.05   0.05"), std::string::npos)
      << text;
  EXPECT_NE(text.find("1 inaccurate"), std::string::npos);
  EXPECT_NE(text.find("fd-kf             6          6       -"), std::string::npos);
}

TEST(SweepTable, FitsTheNarrowestTerminal) {
  std::istringstream lines(sweep_table_text(tests::results_of(tests::small_plan()), {80, false}));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80) << line;
}

}  // namespace
}  // namespace fpkcheck::sweep
