#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/parameter_value.hpp"

namespace fpkcheck::report {

/// Text of a missing or non-finite number on the report page.
inline constexpr std::string_view kNoValue = "\u2013";

/// Returns the text of a number with exactly `digits` significant digits, including trailing zeros:
/// 0.4450, 1.2e-5. If `digits` is 1, the text of a number always has a power of ten: 4e-4.
std::string number_text(const std::optional<double>& value, int digits);

/// Returns the text of the value of a parameter or metric. The text of an integer has all digits,
/// the text of any other number at most `digits` significant digits. A Boolean value becomes "yes"
/// or "no", and a text value is unchanged.
std::string parameter_value_text(const base::Value& value, int digits = 6);

/// Returns the text of an L1 distance for a table cell: 0.0044, 6.0e-6.
std::string l1_distance_cell_text(const std::optional<double>& l1);

/// Returns the text of a time in seconds: 0.0042, 0.21, 16.9, 130.
std::string seconds_text(const std::optional<double>& seconds);

/// Returns the text of an L1 distance with five decimals, or with two significant digits below
/// 1e-4.
std::string l1_distance_text(double l1);

struct IntervalText {
  std::string lower, upper;
};
/// Rounds the ends of an interval outwards to decimal numbers. The number of decimals gives the
/// width of the interval two significant digits, so that the texts of the two ends differ.
IntervalText round_interval_outward(double lower, double upper);

}  // namespace fpkcheck::report
