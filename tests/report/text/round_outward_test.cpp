#include "report/text/round_outward.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace fpkcheck::report {
namespace {

TEST(RoundOutward, RoundsTheLowerEndDownAndTheUpperEndUp) {
  const auto [lower, upper] = round_outward(0.394518051, 0.394518309);
  EXPECT_EQ(lower, "0.39451805");
  EXPECT_EQ(upper, "0.39451831");
}

TEST(RoundOutward, KeepsNegativeEndsOutside) {
  const auto [lower, upper] = round_outward(-1.234561, -1.234119);
  EXPECT_EQ(lower, "-1.23457");
  EXPECT_EQ(upper, "-1.23411");
}

TEST(RoundOutward, NeverCutsIntoTheInterval) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> middle(-5, 5), power(-11, 1);
  for (int n = 0; n < 20000; ++n) {
    const double a = middle(random), b = a + std::pow(10.0, power(random));
    const auto [lower, upper] = round_outward(a, b);
    ASSERT_LE(std::stod(lower), a) << lower;
    ASSERT_GE(std::stod(upper), b) << upper;
    ASSERT_LE(std::stod(upper) - std::stod(lower), 1.5 * (b - a)) << lower << " " << upper;
  }
}

// The doubles 0.3 and 0.7 are below their decimals, 0.1 and 0.8 above.
TEST(RoundOutward, RoundsTheExactValueOfTheDouble) {
  EXPECT_EQ(round_outward(0.3, 0.4).lower, "0.29");
  EXPECT_EQ(round_outward(0.1, 0.2).lower, "0.10");
  EXPECT_EQ(round_outward(0.5, 0.7).upper, "0.70");
  EXPECT_EQ(round_outward(0.5, 0.8).upper, "0.81");
}

TEST(RoundOutward, StatesAnInfiniteEnd) {
  EXPECT_EQ(round_outward(0, std::numeric_limits<double>::infinity()).upper, "inf");
}

}  // namespace
}  // namespace fpkcheck::report
