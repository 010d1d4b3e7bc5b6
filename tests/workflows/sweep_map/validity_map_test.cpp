#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "base/input_error.hpp"
#include "made_up_map.hpp"
#include "methods/builtin_solvers.hpp"
#include "paper_cases.hpp"
#include "refusal.hpp"
#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {
namespace {

// Units of length and time reduced to a third and a half: c and lambda become 2 times as large, k 4
// times, mu 4 * 9 times, and lambda E[Y^2], a squared velocity per time, 2 * 4 / 9 times.
TEST(DimensionlessGroups, DoNotDependOnUnits) {
  const auto one = dimensionless_groups(tests::make_problem({}));
  const auto other = dimensionless_groups(tests::make_problem(
      {.damping = 0.2, .stiffness = 4, .cubic = 0.1 * 36, .rate = 2, .intensity = 0.1 * 8 / 9}));
  EXPECT_NEAR(one.impulses_per_decay_time, other.impulses_per_decay_time, 1e-9);
  EXPECT_NEAR(one.damping_ratio, other.damping_ratio, 1e-12);
  EXPECT_NEAR(one.cubic_share, other.cubic_share, 1e-12);
}

TEST(DimensionlessGroups, OfALinearSpringAndOfAPurelyCubicOne) {
  EXPECT_NEAR(dimensionless_groups(tests::make_problem({.cubic = 0})).cubic_share, 0, 1e-12);
  EXPECT_NEAR(dimensionless_groups(tests::make_problem({.stiffness = 0})).cubic_share, 1, 1e-12);
  EXPECT_NEAR(dimensionless_groups(tests::make_problem({.cubic = 0})).damping_ratio, 0.05, 1e-12);
}

using transform::Status;

const std::string kHeader =
    "impulses_per_decay_time,damping_ratio,cubic_share,restitution,law,mean_share,epc-polar-n6,fd-kf\n";

TEST(ReadValidityMap, ReadsPlacesAndAnswers) {
  const auto map = read_validity_map(
      kHeader +
      "10,.05,0,.9,laplace,0,7.1e-05o310,.0001o1200\n2.5,.1,.3,1,gaussian,0,n2100,.004o5");
  EXPECT_EQ(map.methods, (std::vector<std::string>{"epc-polar-n6", "fd-kf"}));
  ASSERT_EQ(map.points.size(), 2);
  const auto& coordinates = map.points[0].coordinates;
  EXPECT_EQ(coordinates.groups.impulses_per_decay_time, 10);
  EXPECT_EQ(coordinates.groups.damping_ratio, 0.05);
  EXPECT_EQ(coordinates.restitution, 0.9);
  EXPECT_EQ(coordinates.law, "laplace");
  EXPECT_EQ(map.points[1].coordinates.groups.cubic_share, 0.3);
  const auto& answer = map.points[0].method_results[0];
  EXPECT_EQ(answer->status, Status::ok);
  EXPECT_EQ(answer->l1, 7.1e-5);
  EXPECT_EQ(answer->seconds, 0.31);
  EXPECT_FALSE(answer->underestimated);
  EXPECT_EQ(map.points[1].method_results[0]->status, Status::not_converged);
  EXPECT_FALSE(map.points[1].method_results[0]->l1);
}

TEST(ReadValidityMap, ReadsEveryLetterAndEmptyCells) {
  const auto status_of = [](const std::string& cell) {
    return read_validity_map(kHeader + "1,1,0,1,gaussian,0," + cell + ",.1o1\n")
        .points[0]
        .method_results[0];
  };
  EXPECT_EQ(status_of(".1i5")->status, Status::inaccurate);
  EXPECT_EQ(status_of(".1a5")->status, Status::inadmissible);
  EXPECT_EQ(status_of("p5")->status, Status::ill_posed);
  EXPECT_EQ(status_of("f5")->status, Status::failed);
  EXPECT_EQ(status_of("u5")->status, Status::not_offered);
  EXPECT_TRUE(status_of(".1x5")->has_status_ok());
  EXPECT_TRUE(status_of(".1x5")->underestimated);
  EXPECT_FALSE(status_of(""));
}

TEST(ReadValidityMap, HasADistinctLetterForEveryStatus) {
  // A shared letter would be read as the first of its statuses alone.
  std::set<std::pair<Status, bool>> read;
  for (char letter = 'a'; letter <= 'z'; ++letter) {
    if (letter == 'e') continue;  // occurs in exponents
    try {
      const auto map = read_validity_map(kHeader + "1,1,0,1,gaussian,0,.1" + letter + "5,.1o1\n");
      const auto& answer = *map.points[0].method_results[0];
      EXPECT_TRUE(read.emplace(answer.status, answer.underestimated).second) << letter;
    } catch (const InputError&) {
    }
  }
  std::set<std::pair<Status, bool>> expected{{Status::ok, true}};
  for (const auto& named : enumerator_names(Status{})) expected.emplace(named.value, false);
  EXPECT_EQ(read, expected);
}

TEST(ReadValidityMap, RefusesOtherFiles) {
  EXPECT_THROW(read_validity_map(""), InputError);
  EXPECT_THROW(read_validity_map("a,b\n1,2\n"), InputError);
  for (const std::string row :
       {"1,1,0,1,gaussian,0,o5", "one,1,0,1,gaussian,0,,.1o1", "1,0,0,1,gaussian,0,,.1o1",
        "1,1,0,nan,gaussian,0,,.1o1", "1,1,-1,1,gaussian,0,,.1o1", "1,1,0,1,gaussian,0,.1q5,.1o1",
        "1,1,0,1,gaussian,0,.1o,.1o1", "1,1,0,1,gaussian,0,o5,.1o1", "1,1,0,1,gaussian,0,.1o5,"}) {
    EXPECT_THROW(read_validity_map(kHeader + row + '\n'), InputError) << row;
  }
}

TEST(ShippedValidityMap, HasExistingMethods) {
  const auto& map = shipped_validity_map();
  EXPECT_GT(map.points.size(), 100);
  EXPECT_EQ(map.methods.back(), "fd-kf");
  for (const auto& id : map.methods)
    EXPECT_TRUE(methods::builtin_registry().find_method_by_id(id)) << id;
}

using tests::made_up_place;

TEST(Distance, HasItsUnits) {
  const ValidityMapCoordinates here = made_up_place();
  EXPECT_EQ(validity_map_distance(here, here), 0);
  EXPECT_NEAR(validity_map_distance(here, made_up_place(10 * std::exp(1.0))), 1, 1e-12);
  EXPECT_NEAR(validity_map_distance(here, made_up_place(10, 0.8)), 1, 1e-12);
  ValidityMapCoordinates other = here;
  other.groups.damping_ratio *= std::exp(-1.0);
  EXPECT_NEAR(validity_map_distance(here, other), 1, 1e-12);
  other = here;
  other.groups.cubic_share = 0.2;
  EXPECT_NEAR(validity_map_distance(here, other), 1, 1e-12);
}

TEST(Distance, AddsSquares) {
  ValidityMapCoordinates other = made_up_place(10 * std::exp(1.0), 0.8);
  other.groups.cubic_share = 0.2;
  other.groups.damping_ratio *= std::exp(1.0);
  EXPECT_NEAR(validity_map_distance(made_up_place(), other), 2, 1e-12);
  EXPECT_NEAR(validity_map_distance(other, made_up_place()), 2, 1e-12);
}

TEST(Distance, IsInfiniteBetweenDifferentLawsOrMeans) {
  ValidityMapCoordinates law = made_up_place(), mean = made_up_place();
  law.law = "uniform";
  mean.relative_mean = 0.1;
  EXPECT_TRUE(std::isinf(validity_map_distance(made_up_place(), law)));
  EXPECT_TRUE(std::isinf(validity_map_distance(made_up_place(), mean)));
}

TEST(PlaceOf, HaveTheRelativeMean) {
  // E[Y^2] = 0.1 / 0.4 = 0.25.
  EXPECT_NEAR(
      validity_map_coordinates(tests::make_problem({.rate = 0.4, .mean = -0.2})).relative_mean,
      -0.4, 1e-12);
  EXPECT_EQ(validity_map_coordinates(tests::make_problem({.law = "laplace"})).law, "laplace");
  EXPECT_EQ(validity_map_coordinates(tests::make_problem({.restitution = 0.7})).restitution, 0.7);
}

}  // namespace
}  // namespace fpkcheck::sweep
