#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "base/options/parameter.hpp"

namespace fpkcheck::sweep {

enum class AxisSpacing { linear, logarithmic, listed };
inline constexpr base::EnumEntry<AxisSpacing> kSpacingNames[] = {{AxisSpacing::linear, "linear"},
                                                                 {AxisSpacing::logarithmic, "log"},
                                                                 {AxisSpacing::listed, "list"}};
constexpr const auto& enumerator_names(AxisSpacing) { return kSpacingNames; }
constexpr std::string_view name(AxisSpacing spacing) { return base::name_of(spacing); }

/// A key of case files that the sweep varies, and the values of this key.
struct SweepAxis {
  std::string key;  ///< varied key, e.g. "system.restitution"
  AxisSpacing spacing = AxisSpacing::listed;
  double from = 0, to = 0;  ///< ends of the range of a numerical key
  /// Values of the key: numbers, or words such as "gaussian". The list is empty for a range of a
  /// Sobol sequence.
  std::vector<base::Value> values = {};

  /// Returns the value of the key at a relative position in the range, rounded to 12 digits.
  /// @param part relative position, 0 <= part <= 1
  double value_at_fraction(double part) const;
  /// Returns the axis as text, e.g. "system.restitution = 0.5:0.99:50".
  std::string definition_text() const;
};

/// Parses an axis in the syntax KEY=FROM:TO:N, KEY=FROM:TO or KEY=A,B,.., with "log:" before FROM
/// for a logarithmic axis.
/// @param error_context first words of error messages, e.g. "--vary" or "plan mine.ini:7"
/// @throws InputError if the syntax is invalid, a value is outside the range of the key, or a value
///         occurs twice
SweepAxis parse_sweep_axis(std::string_view key, std::string_view values,
                           const std::string& error_context);

}  // namespace fpkcheck::sweep
