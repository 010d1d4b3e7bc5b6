#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fpkcheck::base {

/// What a parameter was set to; nothing (std::monostate): automatic, or not there.
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

inline bool is_nothing(const Value& value) { return std::holds_alternative<std::monostate>(value); }

/// As people read it: numbers with the digits that it takes to read them back, words in quotes,
/// "automatic" for nothing.
std::string text_of(const Value& value);

}  // namespace fpkcheck::base
