#include "report/page/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "report/page/html.hpp"

namespace fpkcheck::report {
namespace {

TEST(NumberText, KeepsItsDigitsTwoOfADistance) {
  EXPECT_EQ(number_text(0.445, 4), "0.4450");
  EXPECT_EQ(number_text(4.34, 4), "4.340");
  EXPECT_EQ(number_text(6e-5, 2), "6.0e-5");
  EXPECT_EQ(number_text(150, 3), "150");
  EXPECT_EQ(number_text(0.0004, 1), "4e-4");
  EXPECT_EQ(l1_cell_text(0.03), "0.030");
  EXPECT_EQ(l1_cell_text(0.004412), "0.0044");
  EXPECT_EQ(l1_cell_text(6e-6), "6.0e-6");
  EXPECT_EQ(l1_cell_text({}), kNoValue);
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
    EXPECT_EQ(value_text(value), kNoValue);
    EXPECT_EQ(l1_cell_text(value), kNoValue);
    EXPECT_EQ(seconds_text(value), kNoValue);
  }
}

TEST(ValueText, IsThatOfEachKindOfValue) {
  EXPECT_EQ(value_text({}), kNoValue);
  EXPECT_EQ(value_text(true), "yes");
  EXPECT_EQ(value_text(false), "no");
  EXPECT_EQ(value_text(std::int64_t{4207616}, 2), "4207616");
  EXPECT_EQ(value_text(0.1), "0.1");
  EXPECT_EQ(value_text(12.0), "12");
  EXPECT_EQ(value_text(1.23456e-9, 4), "1.235e-9");
  EXPECT_EQ(value_text(std::string("confined")), "confined");
}

}  // namespace
}  // namespace fpkcheck::report
