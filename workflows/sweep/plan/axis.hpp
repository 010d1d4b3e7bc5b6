#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/names.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::sweep {

/// How the values of an axis lie.
enum class Spacing { linear, logarithmic, listed };
inline constexpr base::Named<Spacing> kSpacingNames[] = {
    {Spacing::linear, "linear"}, {Spacing::logarithmic, "log"}, {Spacing::listed, "list"}};
constexpr std::span<const base::Named<Spacing>> names(Spacing) { return kSpacingNames; }
constexpr std::string_view name(Spacing spacing) { return base::name_of(spacing); }

/// A key of case files that is varied, and the values that it takes.
struct Axis {
  std::string key;  ///< "system.restitution"
  Spacing spacing = Spacing::listed;
  double from = 0, to = 0;  ///< of a range
  /// Numbers, or words ("gaussian"); empty for a range without a number of points, which a Sobol
  /// sequence fills.
  std::vector<base::Value> values = {};

  /// Where 0 <= part <= 1 of the way from `from` to `to` leads, to 12 digits.
  double at(double part) const;
  /// For pictures and sentences: "system.restitution = 0.5:0.99:50".
  std::string text() const;
};

/// The axis that is asked for by KEY=FROM:TO:N, KEY=log:FROM:TO:N, the same without N, or
/// KEY=A,B,..
/// @param where how messages begin: "--vary", "plan mine.ini:7"
/// @throws InputError on one line: what is not understood, the key's range, twice the same value
Axis axis_from(std::string_view key, std::string_view values, const std::string& where);

}  // namespace fpkcheck::sweep
