#include "workflows/check/claim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fpkcheck::check {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The comparison of a single quantity in two runs.
Figure held(const Claim& was, const Claim& is) {
  const auto figures = held_against("case", {was}, {is});
  EXPECT_EQ(figures.size(), 1u);
  return figures.at(0);
}

Claim number(double value, FigureKind kind = FigureKind::mass, double scale = 1) {
  Claims claims;
  return Part{claims, "solution", kWhole}.number("x", kind, value, 0.1, scale);
}

TEST(Claim, NumbersChangeInUnitsOfTheScaleOfTheBaseline) {
  const auto change = [](double was, double is, double scale = 1) {
    const auto kind = FigureKind::mass;
    return held(number(was, kind, scale), number(is, kind, 7)).change;
  };
  EXPECT_EQ(change(1, 3), 2);
  EXPECT_EQ(change(3, 1, 4), 0.5);
  EXPECT_EQ(change(0, 0, 0), 0);
  EXPECT_EQ(change(0, 1, 0), kInfinity);
  EXPECT_EQ(change(NAN, NAN), 0);
  EXPECT_EQ(change(kInfinity, NAN), 0);  // both are empty values in files
  EXPECT_EQ(change(NAN, 1), kInfinity);
  EXPECT_EQ(change(1, NAN), kInfinity);
}

TEST(Claim, ErrorsChangeByTheirRatio) {
  const auto change = [](double was, double is) {
    const auto kind = FigureKind::simulated_error;
    return held(number(was, kind), number(is, kind)).change;
  };
  EXPECT_EQ(change(1, 3), 2);
  EXPECT_EQ(change(3, 1), 2);
  EXPECT_EQ(change(2, 2), 0);
  EXPECT_EQ(change(0, 1), kInfinity);
  EXPECT_EQ(change(1, -1), kInfinity);
  EXPECT_EQ(change(1, NAN), kInfinity);
}

TEST(Claim, WhatIsSimulatedChangesInStandardErrorsOfBoth) {
  const auto change = [](double error_was, double error_is) {
    Claim was = number(1, FigureKind::simulated), is = number(6, FigureKind::simulated);
    was.error = error_was;
    is.error = error_is;
    return held(was, is).change;
  };
  EXPECT_DOUBLE_EQ(change(3, 4), 1);
  EXPECT_DOUBLE_EQ(change(NAN, 1), 5 / std::sqrt(2.0));  // the baseline states no error
  EXPECT_EQ(change(1, NAN), kInfinity);
  EXPECT_EQ(change(0, 0), kInfinity);
}

TEST(Claim, AnL1IsAllowedItsExpectationAndSomeScatter) {
  Claim claim = number(0, FigureKind::simulated_l1);
  claim.error = 0.01;
  claim.in_99 = 0.03;
  claim.allowed = 0;
  EXPECT_NEAR(held(claim, claim).allowed, std::hypot(0.01, 0.01), 1e-12);
  claim.allowed = 2.326;  // 99 % quantile of the normal law
  EXPECT_NEAR(held(claim, claim).allowed, std::hypot(0.03, 0.03), 1e-12);
}

TEST(Claim, WordsMustBeTheSame) {
  const auto moved = [](const base::Value& was, const base::Value& is) {
    Claims one, other;
    Part{one, "solution", kWhole}.word("x", was);
    Part{other, "solution", kWhole}.word("x", is);
    return held(one[0], other[0]).moved();
  };
  EXPECT_FALSE(moved("ok", "ok"));
  EXPECT_TRUE(moved("ok", "failed"));
  EXPECT_TRUE(moved("ok", {}));
  EXPECT_TRUE(moved(false, true));
}

/// A list with this number of entries, in a group.
Claims list(std::size_t entries) {
  Claims claims;
  const Part whole{claims, "solution", kWhole};
  whole.begin(FigureKind::status);
  const Part group = Part{claims, "solution", "group"}.begin(FigureKind::detail);
  const Part one = Part{claims, "solution", "group.list"}.begin(
      FigureKind::detail, static_cast<std::int64_t>(entries), group.name);
  for (std::size_t k = 0; k < entries; ++k) {
    const Part entry{claims, "solution", "group.list[" + std::to_string(k) + ']'};
    entry.begin(FigureKind::detail, "there", one.name)
        .number(entry.name + ".level", FigureKind::detail, static_cast<double>(k), 0);
  }
  return claims;
}

TEST(Claim, ThatAPartIsThereIsNoFigure) {
  EXPECT_EQ(held_against("case", list(3), list(3)).size(), 3u);
}

TEST(Claim, APartThatIsAnotherIsSaidOnce) {
  const auto longer = held_against("case", list(3), list(5));
  ASSERT_EQ(longer.size(), 1u);
  EXPECT_EQ(longer[0].name, "group.list");
  EXPECT_EQ(held_against("case", list(5), list(3)).size(), 1u);
}

TEST(Claim, APartThatOneRunLacksIsSaidOnce) {
  Claims none;
  Part{none, "solution", kWhole}.begin(FigureKind::status);
  const auto lost = held_against("case", list(3), none);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].name, "group");
  EXPECT_EQ(lost[0].baseline, base::Value("there"));
  EXPECT_EQ(lost[0].now, base::Value("missing"));
  const auto won = held_against("case", none, list(3));
  ASSERT_EQ(won.size(), 1u);
  EXPECT_EQ(won[0].baseline, base::Value("missing"));
  ASSERT_EQ(held_against("case", list(3), {}).size(), 1u);
  EXPECT_EQ(held_against("case", list(3), {})[0].name, kWhole);
}

TEST(Claim, ErrorsThatTheBaselineLacksAreNotMissed) {
  const Claim error = number(1, FigureKind::simulated_error);
  EXPECT_TRUE(held_against("case", {}, {error}).empty());
  EXPECT_EQ(held_against("case", {error}, {}).size(), 1u);
  Claims stated;
  Part{stated, "s", kStatedError}
      .begin(FigureKind::status)
      .number("error of E[y]", FigureKind::detail, 1e-3, 1e-8);
  EXPECT_TRUE(held_against("case", {}, stated).empty());
  EXPECT_FALSE(held_against("case", stated, {}).empty());
}

}  // namespace
}  // namespace fpkcheck::check
