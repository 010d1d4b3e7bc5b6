#include <gtest/gtest.h>

#include <cmath>

#include "made_up_sweep.hpp"
#include "results/netcdf/reader.hpp"

namespace fpkcheck::sweep {
namespace {

results::NetCdfReader reader_of(const SweepResults& results) {
  return results::NetCdfReader(netcdf(results, "fpkcheck sweep"));
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
  const auto status = file.read_values("status");
  EXPECT_EQ(status[2], -1);
  EXPECT_EQ(status[0], 0);
  EXPECT_EQ(file.read_values("l1_y")[0], 0.01);
  EXPECT_EQ(file.read_values("reference")[0], 1);
  EXPECT_EQ(file.read_values("budget_closure___impact_ydot")[0], 0.4);
}

TEST(SweepNetCdf, OfAListHasItsPointsAndWords) {
  const Plan plan = tests::plan_of(
      {parse_axis("impulse.law", "gaussian,laplace", "x"), parse_axis("system.cubic", "1,2", "x")},
      PlanDesign::list);
  auto file = reader_of(tests::results_of(plan));
  EXPECT_EQ(file.dimension_names("v2"), (std::vector<std::string>{"point", "solution"}));
  EXPECT_EQ(file.read_labels("impulse.law"), (std::vector<std::string>{"gaussian", "laplace"}));
  EXPECT_EQ(file.read_values("system.cubic"), (std::vector<double>{1, 2}));
}

}  // namespace
}  // namespace fpkcheck::sweep
