#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace fpkcheck::base {

/// A value of an enum, its name in files and on the command line, and its meaning.
template <class Enum>
struct EnumEntry {
  Enum value;
  std::string_view name;
  std::string_view meaning = {};
};

/// Every enum has one table of names, defined beside the enum as `names(Enum)` in its namespace:
///
///     constexpr EnumEntry<Stepper> kStepperNames[] = {{Stepper::cvode, "cvode"}, ...};
///     constexpr std::span<const EnumEntry<Stepper>> names(Stepper) { return kStepperNames; }
///     constexpr std::string_view name(Stepper value) { return base::name_of(value); }
template <class Enum>
constexpr const EnumEntry<Enum>* enum_entry(Enum value) {
  for (const auto& entry : names(value)) {
    if (entry.value == value) return &entry;
  }
  return nullptr;
}

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  const auto* entry = enum_entry(value);
  return entry == nullptr ? std::string_view() : entry->name;
}

template <class Enum>
constexpr std::string_view meaning_of(Enum value) {
  const auto* entry = enum_entry(value);
  return entry == nullptr ? std::string_view() : entry->meaning;
}

/// The enum value with this name; nothing when no value has it.
template <class Enum>
constexpr std::optional<Enum> enum_from_name(std::string_view name) {
  for (const auto& entry : names(Enum{})) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

}  // namespace fpkcheck::base
