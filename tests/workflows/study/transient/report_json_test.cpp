#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "made_up_transient.hpp"

namespace fpkcheck::study {
namespace {

TEST(TransientJson, HasEverySnapshotAndNoInfinities) {
  TransientRun run = tests::made_up_transient();
  run.result.snapshots[2].power_residual = HUGE_VAL;
  const auto json = nlohmann::json::parse(transient_json(run));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("case").at("system").at("restitution"), 0.98);
  EXPECT_EQ(json.at("options").at("until"), 2);
  EXPECT_EQ(json.at("options").at("equation"), "kf");
  EXPECT_FALSE(json.at("options").contains("stepper"));  // for the stationary density alone
  EXPECT_EQ(json.at("start").at("ydot"), 0.25);
  ASSERT_EQ(json.at("snapshots").size(), 5u);
  EXPECT_EQ(json.at("snapshots").at(3).at("moments").at("y2"), 13);
  EXPECT_TRUE(json.at("snapshots").at(2).at("power_residual").is_null());
}

}  // namespace
}  // namespace fpkcheck::study
