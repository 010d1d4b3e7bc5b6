#include "workflows/sweep/report/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "made_up_sweep.hpp"

namespace fpkcheck::sweep {
namespace {

TEST(SweepTable, CountsStatusesAndRanksDistancesOfOkSolutions) {
  auto results = tests::results_of(tests::small_plan());
  results.points[5].methods[0].status = transform::Status::inaccurate;  // the worst, 0.06
  const std::string text = table(results, {100, false});
  EXPECT_NE(text.find("6 points of test, impulse.rate = 1,2, system.restitution = 0.8:1:3"),
            std::string::npos);
  // 0.02, 0.02, 0.03, 0.04, 0.05 are ok: the larger value of both marginals.
  EXPECT_NE(text.find("epc-gaussian-n2   5          0    0.03  0.05   0.05"), std::string::npos)
      << text;
  EXPECT_NE(text.find("1 inaccurate"), std::string::npos);
  EXPECT_NE(text.find("fd-kf             6          6       -"), std::string::npos);
}

TEST(SweepTable, FitsTheNarrowestTerminal) {
  std::istringstream lines(table(tests::results_of(tests::small_plan()), {80, false}));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80) << line;
}

}  // namespace
}  // namespace fpkcheck::sweep
