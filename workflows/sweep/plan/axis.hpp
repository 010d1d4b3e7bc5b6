#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::sweep {

/// Spacing of the values of an axis.
enum class Spacing { linear, logarithmic, listed };
inline constexpr base::EnumEntry<Spacing> kSpacingNames[] = {
    {Spacing::linear, "linear"}, {Spacing::logarithmic, "log"}, {Spacing::listed, "list"}};
constexpr std::span<const base::EnumEntry<Spacing>> names(Spacing) { return kSpacingNames; }
constexpr std::string_view name(Spacing spacing) { return base::name_of(spacing); }

/// A key of case files that is varied, and its values.
struct Axis {
  std::string key;  ///< e.g. "system.restitution"
  Spacing spacing = Spacing::listed;
  double from = 0, to = 0;  ///< ends of a range
  /// Numbers or words ("gaussian"). Empty for a range without a number of points, for a Sobol
  /// sequence.
  std::vector<base::Value> values = {};

  /// Value with the relative position `part` in the range, 0 <= part <= 1, rounded to 12 digits.
  double value_at(double part) const;
  /// Text for figures and sentences: "system.restitution = 0.5:0.99:50".
  std::string text() const;
};

/// Parses an axis in the syntax KEY=FROM:TO:N, KEY=log:FROM:TO:N, the same without N, or KEY=A,B,..
/// @param where first words of error messages: "--vary", "plan mine.ini:7"
/// @throws InputError with a message of one line: invalid syntax, a value outside the key's range,
///         a value given twice
Axis parse_axis(std::string_view key, std::string_view values, const std::string& where);

}  // namespace fpkcheck::sweep
