#include "workflows/sweep/map/map_coordinates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "made_up_map.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::made_up_place;

TEST(Distance, HasItsUnits) {
  const MapCoordinates here = made_up_place();
  EXPECT_EQ(map_distance(here, here), 0);
  EXPECT_NEAR(map_distance(here, made_up_place(10 * std::exp(1.0))), 1, 1e-12);
  EXPECT_NEAR(map_distance(here, made_up_place(10, 0.8)), 1, 1e-12);
  MapCoordinates other = here;
  other.groups.damping_ratio *= std::exp(-1.0);
  EXPECT_NEAR(map_distance(here, other), 1, 1e-12);
  other = here;
  other.groups.cubic_share = 0.2;
  EXPECT_NEAR(map_distance(here, other), 1, 1e-12);
}

TEST(Distance, AddsSquares) {
  MapCoordinates other = made_up_place(10 * std::exp(1.0), 0.8);
  other.groups.cubic_share = 0.2;
  other.groups.damping_ratio *= std::exp(1.0);
  EXPECT_NEAR(map_distance(made_up_place(), other), 2, 1e-12);
  EXPECT_NEAR(map_distance(other, made_up_place()), 2, 1e-12);
}

TEST(Distance, IsInfiniteBetweenDifferentLawsOrMeans) {
  MapCoordinates law = made_up_place(), mean = made_up_place();
  law.law = "uniform";
  mean.relative_mean = 0.1;
  EXPECT_TRUE(std::isinf(map_distance(made_up_place(), law)));
  EXPECT_TRUE(std::isinf(map_distance(made_up_place(), mean)));
}

TEST(PlaceOf, HaveTheRelativeMean) {
  // E[Y^2] = 0.1 / 0.4 = 0.25.
  EXPECT_NEAR(map_coordinates(tests::make_problem({.rate = 0.4, .mean = -0.2})).relative_mean, -0.4,
              1e-12);
  EXPECT_EQ(map_coordinates(tests::make_problem({.law = "laplace"})).law, "laplace");
  EXPECT_EQ(map_coordinates(tests::make_problem({.restitution = 0.7})).restitution, 0.7);
}

}  // namespace
}  // namespace fpkcheck::sweep
