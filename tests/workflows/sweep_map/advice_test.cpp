#include "workflows/sweep/map/method_advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_up_map.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::sweep {
namespace {

using Ids = std::vector<std::string>;
using tests::answer;
using tests::made_up_map;
using tests::made_up_place;
using transform::Status;

Ids promised_ids(const MethodRecommendation& advice) {
  Ids ids;
  for (const auto& one : advice.sufficiently_accurate_methods()) ids.push_back(one.id);
  return ids;
}

Ids promised_ids(const ValidityMap& map, double accuracy = 0.01,
                 const ValidityMapCoordinates& coordinates = made_up_place()) {
  return promised_ids(recommend_methods(coordinates, accuracy, map));
}

const Ids kAll{"epc-moment-n4", "epc-polar-n6", "fd-kf"}, kButTheQuickest{"epc-polar-n6", "fd-kf"};

TEST(MethodRecommendation, HasTheFastestFirst) {
  EXPECT_EQ(promised_ids(made_up_map()), kAll);
  auto map = made_up_map();
  for (auto& point : map.points) point.method_results[0]->seconds = 10;
  EXPECT_EQ(promised_ids(map), (Ids{"epc-polar-n6", "fd-kf", "epc-moment-n4"}));
}

TEST(MethodRecommendation, HasTheMostAccurateFirstAmongSimilarTimes) {
  auto map = made_up_map();
  for (auto& point : map.points) point.method_results[1]->seconds = 0.044;
  EXPECT_EQ(promised_ids(map), (Ids{"epc-polar-n6", "epc-moment-n4", "fd-kf"}));
  for (auto& point : map.points) point.method_results[1]->seconds = 0.046;
  EXPECT_EQ(promised_ids(map), kAll);
  // Methods that are not promised do not matter.
  for (auto& point : map.points) point.method_results[1] = answer(0.0004, 0.03, Status::inaccurate);
  EXPECT_EQ(promised_ids(map), (Ids{"epc-moment-n4", "fd-kf"}));
  EXPECT_EQ(recommend_methods(made_up_place(), 0.01, map).methods.front().id, "epc-moment-n4");
}

TEST(MethodRecommendation, HasTheResultsOfNearbyPoints) {
  const auto found = recommend_methods(made_up_place(), 0.01, made_up_map());
  EXPECT_EQ(found.nearest_distance, 0);
  EXPECT_EQ(found.nearby_points, 5);
  EXPECT_FALSE(found.is_outside_map());
  const auto best = found.sufficiently_accurate_methods().front();
  EXPECT_EQ(best.points, 5);
  EXPECT_EQ(best.ok, 5);
  EXPECT_EQ(best.worst_l1, 0.004);
  EXPECT_EQ(best.seconds, 0.03);
}

TEST(MethodRecommendation, DoesNotPromiseAMethodWithALargeErrorNearby) {
  auto map = made_up_map();
  map.points[4].method_results[0]->l1 = 0.011;
  EXPECT_EQ(promised_ids(map), kButTheQuickest);
  // Results at distant points do not matter.
  map.points[4].coordinates = made_up_place(10, 0.5);
  EXPECT_EQ(promised_ids(map), kAll);
}

TEST(MethodRecommendation, DoesNotPromiseAMethodThatIsNotOkNearby) {
  auto map = made_up_map();
  map.points[0].method_results[0]->status = Status::inaccurate;
  EXPECT_EQ(promised_ids(map), kButTheQuickest);
  map.points[0].method_results[0] = ValidityMapResult{Status::not_converged, {}, false, 0.03};
  EXPECT_EQ(promised_ids(map), kButTheQuickest);
}

TEST(MethodRecommendation, AddsTheErrorOfTheReference) {
  auto map = made_up_map();
  map.points[2].method_results[2]->l1 = 0.007;
  EXPECT_EQ(promised_ids(map), kButTheQuickest);
  // For the reference itself its error estimate counts once.
  EXPECT_EQ(promised_ids(map, 0.0075), (Ids{"epc-polar-n6", "fd-kf"}));
  EXPECT_EQ(promised_ids(map, 0.0069), Ids{});
}

TEST(MethodRecommendation, NeedsFourPointsForEachMethod) {
  auto map = made_up_map();
  map.points[0].method_results[0] = std::nullopt;
  EXPECT_EQ(promised_ids(map), kAll);
  map.points[1].method_results[0] = std::nullopt;
  EXPECT_EQ(promised_ids(map), kButTheQuickest);
  // A distant fourth point counts too.
  map.points.push_back(
      {made_up_place(10, 0.5), {answer(0.5, 0.03), answer(0.5, 0.3), answer(0, 1)}});
  EXPECT_EQ(promised_ids(map), kButTheQuickest);
  map.points.back().method_results[0]->l1 = 0.004;
  EXPECT_EQ(promised_ids(map), kAll);
}

TEST(MethodRecommendation, DetectsAProblemOutsideTheMap) {
  const auto far = recommend_methods(made_up_place(10, 0.7), 0.01, made_up_map());
  EXPECT_TRUE(far.is_outside_map());
  EXPECT_NEAR(far.nearest_distance, 2, 1e-12);
  EXPECT_TRUE(far.sufficiently_accurate_methods().empty());

  const auto mean =
      recommend_methods(tests::make_problem({.mean = 0.1}), 0.01, shipped_validity_map());
  EXPECT_TRUE(mean.is_outside_map());
  EXPECT_TRUE(mean.sufficiently_accurate_methods().empty());
  EXPECT_FALSE(
      recommend_methods(tests::make_problem(), 0.01, shipped_validity_map()).is_outside_map());
}

TEST(MethodRecommendation, CountsUnderestimatedErrors) {
  auto map = made_up_map();
  map.points[1].method_results[0] = ValidityMapResult{Status::ok, 0.02, true, 0.03};
  const auto underestimated = [&](double accuracy) {
    const auto found = recommend_methods(made_up_place(), accuracy, map);
    return std::ranges::find(found.methods, "epc-moment-n4", &MethodResultsAtNearbyPoints::id)
        ->underestimated;
  };
  EXPECT_EQ(underestimated(0.01), 1);
  // The error is below the accuracy.
  EXPECT_EQ(underestimated(0.02), 0);
}

TEST(MethodRecommendation, AStricterAccuracyPromisesNoMoreMethods) {
  const auto& map = shipped_validity_map();
  for (std::size_t k = 0; k < map.points.size(); k += 37) {
    const auto sorted_ids = [&](double accuracy) {
      Ids ids = promised_ids(map, accuracy, map.points[k].coordinates);
      std::ranges::sort(ids);
      return ids;
    };
    Ids looser = sorted_ids(0.1);
    for (const double accuracy : {0.02, 0.01, 0.003, 0.001, 1e-4}) {
      const Ids ids = sorted_ids(accuracy);
      EXPECT_TRUE(std::ranges::includes(looser, ids)) << k << ' ' << accuracy;
      looser = ids;
    }
  }
}

// Units of length and time reduced to a third and a half, as in
// tests/workflows/sweep_map/validity_map_test.cpp.
TEST(MethodRecommendation, DoesNotDependOnUnits) {
  const auto one = recommend_methods(tests::make_problem({}), 0.005, shipped_validity_map());
  const auto other = recommend_methods(
      tests::make_problem(
          {.damping = 0.2, .stiffness = 4, .cubic = 0.1 * 36, .rate = 2, .intensity = 0.1 * 8 / 9}),
      0.005, shipped_validity_map());
  EXPECT_NEAR(one.nearest_distance, other.nearest_distance, 1e-9);
  EXPECT_EQ(one.nearby_points, other.nearby_points);
  EXPECT_FALSE(one.sufficiently_accurate_methods().empty());
  EXPECT_EQ(promised_ids(one), promised_ids(other));
}

}  // namespace
}  // namespace fpkcheck::sweep
