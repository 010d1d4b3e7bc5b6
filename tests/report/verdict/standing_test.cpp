#include "report/verdict/standing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../changed_case.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;

TEST(Standing, GoesByBothDistancesToTheReference) {
  auto one = made_up_case();
  set_l1(one, "epc-gaussian-n6", "mcs", 0.0024, 0.0199);
  set_l1(one, "epc-gaussian-n2", "mcs", 0.0024, 0.0201);
  set_l1(one, "fd-white", "mcs", 0.0201, 0.001);
  EXPECT_EQ(stand_in(one, "epc-gaussian-n6").standing, Standing::close);
  EXPECT_EQ(stand_in(one, "epc-gaussian-n2").standing, Standing::off);
  EXPECT_EQ(stand_in(one, "fd-white").standing, Standing::off);
  EXPECT_EQ(stand_in(one, "mcs").standing, Standing::reference);
  EXPECT_EQ(stand_in(one, "nobody").standing, Standing::absent);
  EXPECT_DOUBLE_EQ(*stand_in(one, "epc-gaussian-n6").farthest(), 0.0199);
}

TEST(Standing, IsIndistinguishableWithinWhatTheReferenceKnowsOfBothMarginals) {
  auto one = made_up_case();  // expected sampling errors of the simulation: 0.0011 and 0.0015
  set_l1(one, "fd-kf", "mcs", 0.0010, 0.0014);
  EXPECT_EQ(stand_in(one, "fd-kf").standing, Standing::indistinguishable);
  set_l1(one, "fd-kf", "mcs", 0.0010, 0.0016);
  EXPECT_EQ(stand_in(one, "fd-kf").standing, Standing::close);
  set_l1(one, "fd-kf", "mcs", 0.0012, 0.0014);
  EXPECT_EQ(stand_in(one, "fd-kf").standing, Standing::close);
}

TEST(Standing, OfWhatIsNoDensityIsNotReproducedHoweverNearItComes) {
  auto one = made_up_case();
  set_l1(one, "epc-gaussian-n4", "mcs", 1e-4, 1e-4);
  EXPECT_EQ(stand_in(one, "epc-gaussian-n4").standing, Standing::no_density);
  EXPECT_EQ(stand_in(one, "epc-gaussian-n8").standing, Standing::no_density);
  EXPECT_FALSE(stand_in(one, "epc-gaussian-n4").reproduces());
  solution_of(one, "epc-gaussian-n4").status = transform::Status::inaccurate;
  EXPECT_TRUE(stand_in(one, "epc-gaussian-n4").reproduces());
}

TEST(Standing, IsUnjudgedWhereThereIsNoReference) {
  const auto one = tests::with_first(4);
  EXPECT_EQ(stand_in(one, "epc-gaussian-n2").standing, Standing::unjudged);
  EXPECT_EQ(stand_in(one, "epc-gaussian-n4").standing, Standing::no_density);
}

TEST(Records, HaveEverySolutionOnceInTheOrderOfTrust) {
  auto first = made_up_case("a"), second = made_up_case("b");
  std::erase_if(first.solutions, [](const auto& s) { return s.id() == "fd-km4"; });
  std::erase_if(second.solutions, [](const auto& s) { return s.id() == "fd-white"; });
  const results::Run run{{}, {first, second}};
  std::vector<std::string> ids;
  for (const auto& record : records(run)) ids.push_back(record.identity->id);
  const auto at = [&](const char* id) { return std::ranges::find(ids, id) - ids.begin(); };
  EXPECT_EQ(ids.size(), 8u);
  EXPECT_LT(at("epc-gaussian-n8"), at("fd-km4"));
  EXPECT_LT(at("fd-km4"), at("fd-kf"));
  EXPECT_EQ(ids.back(), "mcs");
  const auto white = records(run)[static_cast<std::size_t>(at("fd-white"))];
  EXPECT_EQ(white.present(), 1);
  EXPECT_EQ(white.stands[1].standing, Standing::absent);
}

TEST(Records, TellTheFarthestOfAllCasesThatHaveADensity) {
  auto first = made_up_case("a"), second = made_up_case("b");
  set_l1(first, "epc-gaussian-n6", "mcs", 0.003, 0.004);
  set_l1(second, "epc-gaussian-n6", "mcs", 0.005, 0.002);
  const results::Run run{{}, {first, second}};
  for (const auto& record : records(run)) {
    if (record.identity->id == "epc-gaussian-n6") {
      EXPECT_DOUBLE_EQ(*record.largest(&Stand::y), 0.005);
      EXPECT_DOUBLE_EQ(*record.largest(&Stand::ydot), 0.004);
      EXPECT_DOUBLE_EQ(*record.farthest(), 0.005);
    }
    if (record.identity->id == "epc-gaussian-n4") {
      EXPECT_FALSE(record.farthest());
    }
  }
}

}  // namespace
}  // namespace fpkcheck::report
