#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace fpkcheck::base {

/// An enum value with the name that files and the command line use for the value, and its meaning.
template <class Enum>
struct EnumEntry {
  Enum value;
  std::string_view name;
  std::string_view meaning = {};
};

/// Every enum that is read or written by name has one table of names: the function
/// `enumerator_names(Enum)`, defined in the namespace of the enum.
///
///     constexpr EnumEntry<Stepper> kStepperNames[] = {{Stepper::cvode, "cvode"}, ...};
///     constexpr std::span<const EnumEntry<Stepper>> enumerator_names(Stepper) { return kStepperNames; }
///     constexpr std::string_view name(Stepper value) { return base::name_of(value); }
template <class Enum>
constexpr const EnumEntry<Enum>* enum_entry(Enum value) {
  for (const auto& entry : enumerator_names(value)) {
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

/// The enum value with this name; nothing if no value has the name.
template <class Enum>
constexpr std::optional<Enum> enum_from_name(std::string_view name) {
  for (const auto& entry : enumerator_names(Enum{})) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

}  // namespace fpkcheck::base
