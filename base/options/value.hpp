#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fpkcheck::base {

/// The value of a parameter; std::monostate means automatic or absent.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct NamedValue {
  std::string name;
  Value value;

  bool operator==(const NamedValue&) const = default;
};
using Values = std::vector<NamedValue>;

inline bool contains(const Values& values, std::string_view name) {
  return std::ranges::find(values, name, &NamedValue::name) != values.end();
}

inline bool is_unset(const Value& value) { return std::holds_alternative<std::monostate>(value); }

/// The value as text for messages and tables: numbers with the digits that restore them exactly,
/// words in quotes, "automatic" for an unset value.
std::string text_of(const Value& value);

}  // namespace fpkcheck::base
