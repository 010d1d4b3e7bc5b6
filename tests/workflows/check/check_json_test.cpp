#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solved_run.hpp"
#include "workflows/check/check.hpp"

namespace fpkcheck::check {
namespace {

TEST(CheckJson, HasEveryChangeAndEveryKind) {
  auto changed = tests::solved_run();
  tests::scale(tests::solution(changed, "epc-moment-n8").moments.y2, 1e-6);
  tests::solution(changed, "fd-kf").status = transform::Status::failed;
  const auto two = check(tests::paper_baseline(), changed, {});
  const auto json = nlohmann::json::parse(check_json(two, "fpkcheck check b", "b"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["program"]["command"], "fpkcheck check b");
  EXPECT_EQ(json["baseline"], "b");
  EXPECT_EQ(json["agrees"], false);
  EXPECT_EQ(json["figures"], two.changes.size());
  EXPECT_EQ(json["solutions"], 9);
  ASSERT_EQ(json["moved"].size(), 2u);
  const auto& moment = json["moved"][0];
  EXPECT_EQ(moment["case"], "case1");
  EXPECT_EQ(moment["figure"], "E[y^2]");
  EXPECT_NEAR(moment["change"].get<double>(), 1e-6, 1e-12);
  EXPECT_EQ(json["moved"][1]["now"], "failed");
  EXPECT_TRUE(json["moved"][1]["change"].is_null());  // JSON has no infinity
  EXPECT_EQ(json["kinds"].size(), std::size(kQuantityKindNames));
}

}  // namespace
}  // namespace fpkcheck::check
