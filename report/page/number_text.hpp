#pragma once

#include <optional>
#include <string>

#include "base/options/value.hpp"

/// Numbers as the page shows them; a dash for what is absent or not finite.
namespace fpkcheck::report {

/// With exactly this many significant digits, zeros too: 0.4450, 1.2e-5. A single digit, that of
/// residuals, always has its power of ten: 4e-4.
std::string number_text(const std::optional<double>& value, int digits);

/// Whatever a parameter or an observation holds: a count with all its digits, a number with those
/// it has, at most so many, yes or no, a word as it is.
std::string value_text(const base::Value& value, int digits = 6);

/// An L1 distance: 0.0044, 6.0e-6.
std::string l1_cell(const std::optional<double>& l1);

/// Of seconds: 0.0042, 0.21, 16.9, 130.
std::string seconds_text(const std::optional<double>& seconds);

}  // namespace fpkcheck::report
