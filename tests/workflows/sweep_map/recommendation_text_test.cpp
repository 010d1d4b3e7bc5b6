#include "workflows/sweep/report/recommendation_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_map.hpp"
#include "methods/builtin_solvers.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::made_up_map;
using tests::made_up_place;
using transform::Status;

const RecommendationContext kSetting{
    .name = "mine",
    .command = [](const std::string& id) { return "solve by " + id; },
    .fallback_commands = {"solve carefully"},
    .registry = methods::builtin_registry()};

TEST(AdviceText, HasTheCommandAndTheWarnings) {
  auto map = made_up_map();
  map.methods[1] = "fd-km4";
  map.points[3].method_results[1] = ValidityMapResult{Status::ok, 0.06, true, 0.3};
  EXPECT_EQ(recommendation_text(recommend_methods(made_up_place(), 0.01, map), kSetting, 80),
            R"(mine: 10 impulses per decay time, damping ratio 0.05, 0 % of the stiffness
cubic, r = 0.9, gaussian impulses. Nearest point of the map: distance 0; 5
points within 1.

Recommended for L1 0.01 of p(y) and p(y'), met at all nearby points:
  solve by epc-moment-n4

               --- at the points nearby ----
method         points  ok  worst L1  seconds
epc-moment-n4       5   5     0.004     0.03
fd-kf               5   5    0.0001        1

Or:
  solve by fd-kf

Status ok there, but error above twice the stated error: fd-km4 (solves km4/map,
error up to 0.06 at 1 of 5 points).

No guarantee: the map has no data between its points (docs/validity.md). Status
and stated error of a solution refer to this problem itself.
)");
}

TEST(AdviceText, ListsLargeErrorsAndMissingDensities) {
  auto map = made_up_map();
  map.points[3].method_results[0] = ValidityMapResult{Status::inaccurate, 0.06, false, 0.3};
  for (auto& point : map.points) {
    point.method_results[1] = ValidityMapResult{Status::inadmissible, 0.7, false, 0.3};
  }
  const auto text =
      recommendation_text(recommend_methods(made_up_place(), 0.01, map), kSetting, 200);
  EXPECT_NE(
      text.find("Error above 5 % at some of these points, as stated: epc-moment-n4 (0.06).\n"),
      text.npos);
  EXPECT_NE(text.find("No probability density at any of these points: epc-polar-n6.\n"), text.npos);
}

TEST(AdviceText, OutsideTheMapHasMethodsWithErrorEstimates) {
  ValidityMapCoordinates mean = made_up_place();
  mean.relative_mean = -0.3;
  EXPECT_EQ(
      recommendation_text(recommend_methods(mean, 0.01, made_up_map()), kSetting, 200),
      R"(mine: 10 impulses per decay time, damping ratio 0.05, 0 % of the stiffness cubic, r = 0.9, gaussian impulses, mean -0.3 times the root mean square. Outside the map: none of its points has impulses
with a mean.

No method met L1 0.01 at all nearby points. These methods estimate their own errors:
  solve carefully

Status and stated error of a solution refer to this problem itself.
)");
  const auto far = recommendation_text(
      recommend_methods(made_up_place(10, 0.7), 0.01, made_up_map()), kSetting, 200);
  EXPECT_NE(far.find("Outside the map: the nearest point has distance 2 (limit 1)."), far.npos);
}

TEST(AdviceJson, HasAllMethodsAndIsJsonWhereNothingIsNear) {
  const auto json_of = [](const ValidityMapCoordinates& coordinates) {
    return nlohmann::json::parse(recommendation_json(
        recommend_methods(coordinates, 0.01, made_up_map()), kSetting, "asked"));
  };
  const auto near = json_of(made_up_place());
  EXPECT_EQ(near["recommended"], "epc-moment-n4");
  EXPECT_EQ(near["methods"].size(), 3);
  EXPECT_EQ(near["methods"][1]["command"], "solve by epc-polar-n6");
  EXPECT_EQ(near["outside"], false);
  ValidityMapCoordinates law = made_up_place();
  law.law = "uniform";
  const auto outside = json_of(law);
  EXPECT_TRUE(outside["nearest"].is_null());
  EXPECT_TRUE(outside["recommended"].is_null());
  EXPECT_EQ(outside["outside"], true);
  EXPECT_EQ(outside["otherwise"][0], "solve carefully");
}

}  // namespace
}  // namespace fpkcheck::sweep
