#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "made_up_sweep.hpp"
#include "workflows/sweep/result/dimensionless_groups.hpp"

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
      dimensionless_groups(tests::small_plan().problem_at(point));
  return fmt::format("{:.4g},{:.4g},{:.4g}", impulses, damping, cubic);
}

TEST(SweepCsv, HasARowForEachPointAndMethod) {
  const auto lines = lines_of(csv(tests::results_of(tests::small_plan())));
  ASSERT_EQ(lines.size(), 1 + 6 * 2);
  EXPECT_EQ(lines[0],
            "impulse.rate,system.restitution,solution,status,reason,y1,y2,y4,v1,v2,v4,l1_y,l1_ydot,"
            "reference,seconds,error_y,error_ydot,budget_y_closure_and_impact,"
            "budget_ydot_closure_and_impact,impulses_per_decay_time,damping_ratio,cubic_share");
  const std::string groups = groups_text(4);
  EXPECT_EQ(lines[9],
            "2,0.9,epc-gaussian-n2,ok,,0,4,0,0,8,0,0.05,0.02,fd-kf,5,,,0.3,0.4," + groups);
  EXPECT_EQ(lines[10], "2,0.9,fd-kf,ok,,0,4.1,0,0,8.2,0,,,fd-kf,5.1,,,,," + groups);
}

TEST(SweepCsv, QuotesReasonsAndHasEmptyCellsForNaN) {
  auto results = tests::results_of(tests::small_plan());
  results.points[0].methods[0].reason = "a \"b\", c";
  results.points[0].methods[0].status = transform::Status::inadmissible;
  results.points[0].methods[0].moments->y2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lines_of(csv(results))[1],
            "1,0.8,epc-gaussian-n2,inadmissible,\"a \"\"b\"\", c\",0,,0,0,0,0,0.01,0.02,fd-kf,1,,,"
            "0.3,0.4," +
                groups_text(0));
}

}  // namespace
}  // namespace fpkcheck::sweep
