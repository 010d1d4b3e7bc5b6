#include "workflows/check/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace fpkcheck::check {
namespace {

Figure figure(double change, double allowed) {
  return {"case1", "fd-kf", "E[y]", FigureKind::moment, 1.0, 1.0, change, allowed};
}

TEST(Figure, MovesWhenItsChangeIsNotAllowed) {
  EXPECT_FALSE(figure(0, 0).moved());
  EXPECT_FALSE(figure(1, 1).moved());
  EXPECT_TRUE(figure(1.1, 1).moved());
  EXPECT_TRUE(figure(INFINITY, 1).moved());
  EXPECT_TRUE(figure(NAN, 1).moved());
  EXPECT_EQ(figure(1, 4).share(), 0.25);
  EXPECT_EQ(figure(0, 0).share(), 0);
}

TEST(Figure, EveryKindHasANameOfItsOwn) {
  std::set<std::string_view> seen;
  for (const auto& entry : kFigureKindNames) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_TRUE(seen.insert(entry.name).second) << entry.name;
  }
  EXPECT_EQ(name(FigureKind::energy), "balance of power");
  EXPECT_EQ(unit(FigureKind::status), "");
  EXPECT_EQ(unit(FigureKind::simulated_bin), "std errors");
  EXPECT_EQ(unit(FigureKind::budget), "absolute");
}

}  // namespace
}  // namespace fpkcheck::check
