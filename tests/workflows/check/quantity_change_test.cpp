#include "workflows/check/quantity_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace fpkcheck::check {
namespace {

QuantityChange quantity_change(double change, double allowed) {
  return {"case1", "fd-kf", "E[y]", QuantityKind::moment, 1.0, 1.0, change, allowed};
}

TEST(QuantityChange, MovesWhenItsChangeIsNotAllowed) {
  EXPECT_FALSE(quantity_change(0, 0).exceeds_tolerance());
  EXPECT_FALSE(quantity_change(1, 1).exceeds_tolerance());
  EXPECT_TRUE(quantity_change(1.1, 1).exceeds_tolerance());
  EXPECT_TRUE(quantity_change(INFINITY, 1).exceeds_tolerance());
  EXPECT_TRUE(quantity_change(NAN, 1).exceeds_tolerance());
  EXPECT_EQ(quantity_change(1, 4).change_over_tolerance(), 0.25);
  EXPECT_EQ(quantity_change(0, 0).change_over_tolerance(), 0);
}

TEST(QuantityChange, EveryKindHasADistinctName) {
  std::set<std::string_view> seen;
  for (const auto& entry : kQuantityKindNames) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_TRUE(seen.insert(entry.name).second) << entry.name;
  }
  EXPECT_EQ(name(QuantityKind::energy), "balance of power");
  EXPECT_EQ(unit(QuantityKind::status), "");
  EXPECT_EQ(unit(QuantityKind::simulated_bin), "std errors");
  EXPECT_EQ(unit(QuantityKind::budget), "absolute");
}

}  // namespace
}  // namespace fpkcheck::check
