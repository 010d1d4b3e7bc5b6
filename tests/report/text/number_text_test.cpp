#include "report/text/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "report/page/html_elements.hpp"

namespace fpkcheck::report {
namespace {

TEST(NumberText, KeepsItsDigitsTwoOfADistance) {
  EXPECT_EQ(number_text(0.445, 4), "0.4450");
  EXPECT_EQ(number_text(4.34, 4), "4.340");
  EXPECT_EQ(number_text(6e-5, 2), "6.0e-5");
  EXPECT_EQ(number_text(150, 3), "150");
  EXPECT_EQ(number_text(0.0004, 1), "4e-4");
  EXPECT_EQ(l1_distance_cell_text(0.03), "0.030");
  EXPECT_EQ(l1_distance_cell_text(0.004412), "0.0044");
  EXPECT_EQ(l1_distance_cell_text(6e-6), "6.0e-6");
  EXPECT_EQ(l1_distance_cell_text({}), kNoValue);
}

TEST(NumberText, IsShort) {
  EXPECT_EQ(number_text(0.39450001, 4), "0.3945");
  EXPECT_EQ(number_text(-1.234e-5, 2), "-1.2e-5");
  EXPECT_EQ(number_text(1.2e-12, 2), "1.2e-12");
  EXPECT_EQ(number_text(2.98e6, 3), "2.98e6");
  EXPECT_EQ(number_text(1e10, 1), "1e10");
  EXPECT_EQ(number_text(0, 2), "0");
  EXPECT_EQ(number_text({}, 2), kNoValue);
  EXPECT_EQ(seconds_text(0.00421), "0.0042");
  EXPECT_EQ(seconds_text(16.93), "16.9");
  EXPECT_EQ(seconds_text(130.4), "130");
}

TEST(NumberText, ShowsADashForNonFiniteNumbers) {
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {kNotANumber, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(number_text(value, 4), kNoValue);
    EXPECT_EQ(parameter_value_text(value), kNoValue);
    EXPECT_EQ(l1_distance_cell_text(value), kNoValue);
    EXPECT_EQ(seconds_text(value), kNoValue);
  }
}

TEST(ValueText, IsThatOfEachKindOfValue) {
  EXPECT_EQ(parameter_value_text({}), kNoValue);
  EXPECT_EQ(parameter_value_text(true), "yes");
  EXPECT_EQ(parameter_value_text(false), "no");
  EXPECT_EQ(parameter_value_text(std::int64_t{4207616}, 2), "4207616");
  EXPECT_EQ(parameter_value_text(0.1), "0.1");
  EXPECT_EQ(parameter_value_text(12.0), "12");
  EXPECT_EQ(parameter_value_text(1.23456e-9, 4), "1.235e-9");
  EXPECT_EQ(parameter_value_text(std::string("confined")), "confined");
}

TEST(L1Text, HasFiveDecimalsAndTwoDigitsBelowThem) {
  EXPECT_EQ(l1_distance_text(0.123456), "0.12346");
  EXPECT_EQ(l1_distance_text(1e-5), "1.0e-05");
  EXPECT_EQ(l1_distance_text(4.4e-6), "4.4e-06");
  EXPECT_EQ(l1_distance_text(0), "0");
}

TEST(RoundOutward, RoundsTheLowerEndDownAndTheUpperEndUp) {
  const auto [lower, upper] = round_interval_outward(0.394518051, 0.394518309);
  EXPECT_EQ(lower, "0.39451805");
  EXPECT_EQ(upper, "0.39451831");
}

TEST(RoundOutward, KeepsNegativeEndsOutside) {
  const auto [lower, upper] = round_interval_outward(-1.234561, -1.234119);
  EXPECT_EQ(lower, "-1.23457");
  EXPECT_EQ(upper, "-1.23411");
}

TEST(RoundOutward, NeverCutsIntoTheInterval) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> middle(-5, 5), power(-11, 1);
  for (int n = 0; n < 20000; ++n) {
    const double a = middle(random), b = a + std::pow(10.0, power(random));
    const auto [lower, upper] = round_interval_outward(a, b);
    ASSERT_LE(std::stod(lower), a) << lower;
    ASSERT_GE(std::stod(upper), b) << upper;
    ASSERT_LE(std::stod(upper) - std::stod(lower), 1.5 * (b - a)) << lower << " " << upper;
  }
}

// The doubles 0.3 and 0.7 are below their decimals, 0.1 and 0.8 above.
TEST(RoundOutward, RoundsTheExactValueOfTheDouble) {
  EXPECT_EQ(round_interval_outward(0.3, 0.4).lower, "0.29");
  EXPECT_EQ(round_interval_outward(0.1, 0.2).lower, "0.10");
  EXPECT_EQ(round_interval_outward(0.5, 0.7).upper, "0.70");
  EXPECT_EQ(round_interval_outward(0.5, 0.8).upper, "0.81");
}

TEST(RoundOutward, StatesAnInfiniteEnd) {
  EXPECT_EQ(round_interval_outward(0, std::numeric_limits<double>::infinity()).upper, "inf");
}

}  // namespace
}  // namespace fpkcheck::report
