#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "base/options/parameter.hpp"

namespace fpkcheck::sweep {

/// The spacing of the values on an axis of a plan.
enum class Spacing { linear, logarithmic, listed };
inline constexpr base::EnumEntry<Spacing> kSpacingNames[] = {
    {Spacing::linear, "linear"}, {Spacing::logarithmic, "log"}, {Spacing::listed, "list"}};
constexpr const auto& enumerator_names(Spacing) { return kSpacingNames; }
constexpr std::string_view name(Spacing spacing) { return base::name_of(spacing); }

/// An axis of a plan: a key of case files that the sweep varies, and the values of this key.
struct Axis {
  std::string key;  ///< e.g. "system.restitution"
  Spacing spacing = Spacing::listed;
  double from = 0, to = 0;  ///< ends of a range
  /// The values of the key: numbers or words ("gaussian"). The list of values is empty for a range
  /// without a number of points, which only a Sobol sequence uses.
  std::vector<base::Value> values = {};

  /// The value at a relative position in the range, rounded to 12 digits.
  /// @param part relative position, 0 <= part <= 1
  double value_at_fraction(double part) const;
  /// The text of the axis for figures and sentences: "system.restitution = 0.5:0.99:50".
  std::string text() const;
};

/// Parses an axis in the syntax KEY=FROM:TO:N, KEY=log:FROM:TO:N, KEY=FROM:TO, KEY=log:FROM:TO, or
/// KEY=A,B,..
/// @param where first words of error messages: "--vary", "plan mine.ini:7"
/// @throws InputError with a message of one line if the syntax is invalid, a value is outside the
///         range of the key, or a value occurs twice
Axis parse_axis(std::string_view key, std::string_view values, const std::string& where);

}  // namespace fpkcheck::sweep
