#include "workflows/sweep/plan/axis.hpp"

#include <gtest/gtest.h>

#include "base/input_error.hpp"

namespace fpkcheck::sweep {
namespace {

using base::Value;

std::vector<double> numbers(const Axis& axis) {
  std::vector<double> found;
  for (const auto& value : axis.values) found.push_back(std::get<double>(value));
  return found;
}

TEST(Axis, RangesHaveBothEndsAndEvenSteps) {
  EXPECT_EQ(numbers(parse_axis("system.restitution", "0.5:0.99:8", "x")),
            (std::vector<double>{0.5, 0.57, 0.64, 0.71, 0.78, 0.85, 0.92, 0.99}));
  EXPECT_EQ(numbers(parse_axis("system.restitution", "1:0.8:3", "x")),
            (std::vector<double>{1, 0.9, 0.8}));
}

TEST(Axis, LogarithmicRangesHaveEvenRatios) {
  EXPECT_EQ(numbers(parse_axis("impulse.rate", "log:0.01:100:5", "x")),
            (std::vector<double>{0.01, 0.1, 1, 10, 100}));
}

TEST(Axis, ListsKeepTheirOrderAndMayHaveWords) {
  EXPECT_EQ(numbers(parse_axis("impulse.rate", "3, 1 ,2", "x")), (std::vector<double>{3, 1, 2}));
  EXPECT_EQ(parse_axis("impulse.law", "laplace,gaussian", "x").values,
            (std::vector<Value>{std::string("laplace"), std::string("gaussian")}));
}

TEST(Axis, WithoutACountIsARangeWithoutValues) {
  const Axis axis = parse_axis("impulse.rate", "log:0.1:10", "x");
  EXPECT_TRUE(axis.values.empty());
  EXPECT_NEAR(axis.value_at_fraction(0.5), 1, 1e-12);
  EXPECT_EQ(axis.text(), "impulse.rate = log:0.1:10");
}

TEST(Axis, ReportsInvalidInput) {
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> bad{
      {{"system.wall", "1,2"}, "unknown key 'system.wall'"},
      {{"system.restitution", "0.5:1.1:3"}, "system.restitution = 1.1"},
      {{"system.restitution", "0.5,0"}, "system.restitution = 0"},
      {{"impulse.rate", "log:0:1:3"}, "0"},
      {{"impulse.rate", "1:2:1"}, "'1' is no number of points"},
      {{"impulse.rate", "1:2:1e3"}, "'1e3' is no number of points"},
      {{"impulse.rate", "1:2:3:4"}, "write FROM:TO:N"},
      {{"impulse.rate", "2:2:5"}, "two ends that differ"},
      {{"impulse.mean", "log:-1:1:5"}, "must be positive"},
      {{"impulse.rate", "1,2,1"}, "twice"},
      {{"impulse.rate", ""}, "''"},
      {{"impulse.rate", "1,two"}, "'two'"},
      {{"impulse.law", "gaussian:laplace:2"}, "a word has no range"},
      {{"impulse.law", "cauchy"}, "cauchy"}};
  for (const auto& [input, message] : bad) {
    SCOPED_TRACE(input.first + "=" + input.second);
    try {
      parse_axis(input.first, input.second, "--vary");
      ADD_FAILURE() << "was accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace fpkcheck::sweep
