#pragma once

#include <optional>
#include <string>

#include "base/options/value.hpp"

/// Texts of numbers on the page; a dash for a missing or non-finite number.
namespace fpkcheck::report {

/// A number with exactly this many significant digits, including zeros: 0.4450, 1.2e-5. A single
/// digit, as for residuals, always has a power of ten: 4e-4.
std::string number_text(const std::optional<double>& value, int digits);

/// The value of a parameter or metric: an integer with all digits, a number with at most `digits`
/// digits, a Boolean as yes or no, text unchanged.
std::string value_text(const base::Value& value, int digits = 6);

/// An L1 distance: 0.0044, 6.0e-6.
std::string l1_cell(const std::optional<double>& l1);

/// A time in seconds: 0.0042, 0.21, 16.9, 130.
std::string seconds_text(const std::optional<double>& seconds);

}  // namespace fpkcheck::report
