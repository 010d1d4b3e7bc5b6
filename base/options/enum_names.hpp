#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::base {

/// An enumerator with its name in files and on the command line, and its meaning.
template <class Enum>
struct EnumEntry {
  Enum value;
  std::string_view name;
  std::string_view meaning = {};
};

/// Every enum that is read or written by name has a table of names. The function
/// `enumerator_names(Enum)` in the namespace of the enum returns the table of names.
///
///     constexpr EnumEntry<Stepper> kStepperNames[] = {{Stepper::cvode, "cvode"}, ...};
///     constexpr const auto& enumerator_names(Stepper) { return kStepperNames; }
///     constexpr std::string_view name(Stepper value) { return base::name_of(value); }
template <class Enum>
constexpr const EnumEntry<Enum>* find_enum_entry(Enum value) {
  for (const auto& entry : enumerator_names(value)) {
    if (entry.value == value) return &entry;
  }
  return nullptr;
}

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  const auto* entry = find_enum_entry(value);
  return entry == nullptr ? std::string_view() : entry->name;
}

template <class Enum>
constexpr std::string_view meaning_of(Enum value) {
  const auto* entry = find_enum_entry(value);
  return entry == nullptr ? std::string_view() : entry->meaning;
}

template <class Enum>
constexpr std::optional<Enum> enum_from_name(std::string_view name) {
  for (const auto& entry : enumerator_names(Enum{})) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

/// @param label start of the error message: "--design", "plan mine.ini, line 3: design"
/// @param choices accepted enumerators with their names
/// @throws InputError if no accepted enumerator has the name `text`
template <class Enum>
Enum parse_enum(const std::string& label, const std::string& text,
                std::span<const EnumEntry<Enum>> choices = enumerator_names(Enum{})) {
  std::string known;
  for (const auto& entry : choices) {
    if (entry.name == text) return entry.value;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(label + ' ' + in_quotes(text) + " (must be one of " + known + ')');
}

}  // namespace fpkcheck::base
