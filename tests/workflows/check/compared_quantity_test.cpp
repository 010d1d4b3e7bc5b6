#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "workflows/check/compared_quantity.hpp"

namespace fpkcheck::check {
namespace {

CheckedQuantityChange quantity_change(double change, double allowed) {
  return {"case1", "fd-kf", "E[y]", CheckedQuantityKind::moment, 1.0, 1.0, change, allowed};
}

TEST(QuantityChange, MovesWhenItsChangeIsNotAllowed) {
  EXPECT_FALSE(quantity_change(0, 0).exceeds_tolerance());
  EXPECT_FALSE(quantity_change(1, 1).exceeds_tolerance());
  EXPECT_TRUE(quantity_change(1.1, 1).exceeds_tolerance());
  EXPECT_TRUE(quantity_change(INFINITY, 1).exceeds_tolerance());
  EXPECT_TRUE(quantity_change(NAN, 1).exceeds_tolerance());
  EXPECT_EQ(quantity_change(1, 4).change_divided_by_tolerance(), 0.25);
  EXPECT_EQ(quantity_change(0, 0).change_divided_by_tolerance(), 0);
}

TEST(QuantityChange, EveryKindHasADistinctName) {
  std::set<std::string_view> seen;
  for (const auto& entry : kQuantityKindNames) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_TRUE(seen.insert(entry.name).second) << entry.name;
  }
  EXPECT_EQ(name(CheckedQuantityKind::energy), "balance of power");
  EXPECT_EQ(unit_of_change(CheckedQuantityKind::status), "");
  EXPECT_EQ(unit_of_change(CheckedQuantityKind::simulated_bin), "std errors");
  EXPECT_EQ(unit_of_change(CheckedQuantityKind::budget), "absolute");
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The comparison of a single quantity in two runs.
CheckedQuantityChange held(const CheckedQuantity& was, const CheckedQuantity& is) {
  const auto changes = compare_quantities("case", {was}, {is});
  EXPECT_EQ(changes.size(), 1u);
  return changes.at(0);
}

CheckedQuantity number(double value, CheckedQuantityKind kind = CheckedQuantityKind::mass,
                       double scale = 1) {
  CheckedQuantities quantities;
  return SolutionPartQuantityAppender{quantities, "solution", kWholeSolutionPart}
      .append_number_quantity("x", kind, value, 0.1, scale);
}

TEST(Quantity, NumbersChangeInUnitsOfTheScaleOfTheBaseline) {
  const auto change = [](double was, double is, double scale = 1) {
    const auto kind = CheckedQuantityKind::mass;
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

TEST(Quantity, ErrorsChangeByTheirRatio) {
  const auto change = [](double was, double is) {
    const auto kind = CheckedQuantityKind::simulated_error;
    return held(number(was, kind), number(is, kind)).change;
  };
  EXPECT_EQ(change(1, 3), 2);
  EXPECT_EQ(change(3, 1), 2);
  EXPECT_EQ(change(2, 2), 0);
  EXPECT_EQ(change(0, 1), kInfinity);
  EXPECT_EQ(change(1, -1), kInfinity);
  EXPECT_EQ(change(1, NAN), kInfinity);
}

TEST(Quantity, SimulatedNumbersChangeInStandardErrorsOfBoth) {
  const auto change = [](double error_was, double error_is) {
    CheckedQuantity was = number(1, CheckedQuantityKind::simulated),
                    is = number(6, CheckedQuantityKind::simulated);
    was.error = error_was;
    is.error = error_is;
    return held(was, is).change;
  };
  EXPECT_DOUBLE_EQ(change(3, 4), 1);
  EXPECT_DOUBLE_EQ(change(NAN, 1), 5 / std::sqrt(2.0));  // the baseline states no error
  EXPECT_EQ(change(1, NAN), kInfinity);
  EXPECT_EQ(change(0, 0), kInfinity);
}

TEST(Quantity, AnL1IsAllowedItsExpectationAndSomeScatter) {
  CheckedQuantity quantity = number(0, CheckedQuantityKind::simulated_l1);
  quantity.error = 0.01;
  quantity.quantile_99 = 0.03;
  quantity.allowed = 0;
  EXPECT_NEAR(held(quantity, quantity).allowed, std::hypot(0.01, 0.01), 1e-12);
  quantity.allowed = 2.326;  // 99 % quantile of the normal law
  EXPECT_NEAR(held(quantity, quantity).allowed, std::hypot(0.03, 0.03), 1e-12);
}

TEST(Quantity, WordsMustBeTheSame) {
  const auto moved = [](const base::Value& was, const base::Value& is) {
    CheckedQuantities one, other;
    SolutionPartQuantityAppender{one, "solution", kWholeSolutionPart}.append_word_quantity("x",
                                                                                           was);
    SolutionPartQuantityAppender{other, "solution", kWholeSolutionPart}.append_word_quantity("x",
                                                                                             is);
    return held(one[0], other[0]).exceeds_tolerance();
  };
  EXPECT_FALSE(moved("ok", "ok"));
  EXPECT_TRUE(moved("ok", "failed"));
  EXPECT_TRUE(moved("ok", {}));
  EXPECT_TRUE(moved(false, true));
}

/// A list with this number of entries, in a group.
CheckedQuantities list(std::size_t entries) {
  CheckedQuantities quantities;
  const SolutionPartQuantityAppender whole{quantities, "solution", kWholeSolutionPart};
  whole.begin_part(CheckedQuantityKind::status);
  const SolutionPartQuantityAppender group =
      SolutionPartQuantityAppender{quantities, "solution", "group"}.begin_part(
          CheckedQuantityKind::detail);
  const SolutionPartQuantityAppender one =
      SolutionPartQuantityAppender{quantities, "solution", "group.list"}.begin_part(
          CheckedQuantityKind::detail, static_cast<std::int64_t>(entries), group.name);
  for (std::size_t k = 0; k < entries; ++k) {
    const SolutionPartQuantityAppender entry{quantities, "solution",
                                             "group.list[" + std::to_string(k) + ']'};
    entry.begin_part(CheckedQuantityKind::detail, "there", one.name)
        .append_number_quantity(entry.name + ".level", CheckedQuantityKind::detail,
                                static_cast<double>(k), 0);
  }
  return quantities;
}

TEST(Quantity, PresenceOfAPartIsNotCounted) {
  EXPECT_EQ(compare_quantities("case", list(3), list(3)).size(), 3u);
}

TEST(Quantity, ReportsAChangedPartOnce) {
  const auto longer = compare_quantities("case", list(3), list(5));
  ASSERT_EQ(longer.size(), 1u);
  EXPECT_EQ(longer[0].name, "group.list");
  EXPECT_EQ(compare_quantities("case", list(5), list(3)).size(), 1u);
}

TEST(Quantity, ReportsAMissingPartOnce) {
  CheckedQuantities none;
  SolutionPartQuantityAppender{none, "solution", kWholeSolutionPart}.begin_part(
      CheckedQuantityKind::status);
  const auto lost = compare_quantities("case", list(3), none);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].name, "group");
  EXPECT_EQ(lost[0].baseline, base::Value("there"));
  EXPECT_EQ(lost[0].now, base::Value("missing"));
  const auto won = compare_quantities("case", none, list(3));
  ASSERT_EQ(won.size(), 1u);
  EXPECT_EQ(won[0].baseline, base::Value("missing"));
  ASSERT_EQ(compare_quantities("case", list(3), {}).size(), 1u);
  EXPECT_EQ(compare_quantities("case", list(3), {})[0].name, kWholeSolutionPart);
}

TEST(Quantity, IgnoresErrorsThatTheBaselineLacks) {
  const CheckedQuantity error = number(1, CheckedQuantityKind::simulated_error);
  EXPECT_TRUE(compare_quantities("case", {}, {error}).empty());
  EXPECT_EQ(compare_quantities("case", {error}, {}).size(), 1u);
  CheckedQuantities stated;
  SolutionPartQuantityAppender{stated, "s", kErrorEstimatePart}
      .begin_part(CheckedQuantityKind::status)
      .append_number_quantity("error of E[y]", CheckedQuantityKind::detail, 1e-3, 1e-8);
  EXPECT_TRUE(compare_quantities("case", {}, stated).empty());
  EXPECT_FALSE(compare_quantities("case", stated, {}).empty());
}

}  // namespace
}  // namespace fpkcheck::check
