#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fpkcheck::base {

/// The value of a parameter. std::monostate represents an automatic or absent value.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct NamedParameterValue {
  std::string name;
  Value value;

  bool operator==(const NamedParameterValue&) const = default;
};
using Values = std::vector<NamedParameterValue>;

inline bool contains(const Values& values, std::string_view name) {
  return std::ranges::find(values, name, &NamedParameterValue::name) != values.end();
}

inline bool is_unset(const Value& value) { return std::holds_alternative<std::monostate>(value); }

/// The text of a value for messages and tables. A number has all the digits that are needed to read
/// back the same number, a word is in quotes, and an unset value is "automatic".
std::string text_of(const Value& value);

}  // namespace fpkcheck::base
