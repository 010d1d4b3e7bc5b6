#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/parameter.hpp"

/// Texts of numbers in tables and on the page.
namespace fpkcheck::report {

/// The text of a missing or non-finite number on the page.
inline constexpr std::string_view kNoValue = "\u2013";

/// The text of a number with exactly `digits` significant digits, including trailing zeros: 0.4450,
/// 1.2e-5. A number with a single digit, such as a residual, always has a power of ten: 4e-4.
std::string number_text(const std::optional<double>& value, int digits);

/// The text of the value of a parameter or metric: an integer has all digits, a number has at most
/// `digits` digits, a Boolean is yes or no, a text is unchanged.
std::string value_text(const base::Value& value, int digits = 6);

/// The text of an L1 distance in a table cell: 0.0044, 6.0e-6.
std::string l1_cell_text(const std::optional<double>& l1);

/// The text of a time in seconds: 0.0042, 0.21, 16.9, 130.
std::string seconds_text(const std::optional<double>& seconds);

/// The text of an L1 distance in tables: five decimals; two significant digits for distances below
/// 1e-4.
std::string l1_text(double l1);

/// The decimal texts of the ends of an interval.
struct IntervalText {
  std::string lower, upper;
};
/// Rounds the ends of an interval outwards to decimals. The number of decimals is large enough to
/// show two significant digits of the interval width, so that the texts of both ends differ.
IntervalText round_outward(double lower, double upper);

}  // namespace fpkcheck::report
