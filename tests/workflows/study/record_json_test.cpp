#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "paper_cases.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {
namespace {

TEST(RecordJson, HasProgramCaseAndRowsByPath) {
  const auto found = nlohmann::json::parse(study_json(
      "test", tests::make_problem({.restitution = 0.9}), "fpkcheck study test",
      {{"truth.order", transform::value_from_count(5)}, {"truth.reason", std::string()}},
      {{"rows", {{{"at.x", 0.125}, {"at.y", HUGE_VAL}}, {{"at", {}}}}}, {"others", {}}}));
  EXPECT_EQ(found.at("schema"), 1);
  EXPECT_EQ(found.at("program").at("command"), "fpkcheck study test");
  EXPECT_EQ(found.at("study"), "test");
  EXPECT_EQ(found.at("name"), "test");
  EXPECT_EQ(found.at("system").at("restitution"), 0.9);
  EXPECT_EQ(found.at("impulse").at("moments").size(), 7u);
  EXPECT_EQ(found.at("truth").at("order"), 5);
  EXPECT_EQ(found.at("rows").at(0).at("at").at("x"), 0.125);
  EXPECT_TRUE(found.at("rows").at(0).at("at").at("y").is_null());
  EXPECT_TRUE(found.at("rows").at(1).at("at").is_null());
  EXPECT_TRUE(found.at("others").is_array());
}

}  // namespace
}  // namespace fpkcheck::study
