#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "base/input_error.hpp"
#include "base/options/enum_names.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::base {

/// Converts a name that a user typed to the enum value with this name.
/// @param label start of the error message: "--design", "plan mine.ini, line 3: design"
/// @param choices accepted enum values with their names
/// @throws InputError if no accepted value has the name `text`
template <class Enum>
Enum parse_enum(const std::string& label, const std::string& text,
                std::span<const EnumEntry<Enum>> choices = enumerator_names(Enum{})) {
  std::string known;
  for (const auto& entry : choices) {
    if (entry.name == text) return entry.value;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(fmt::format("{} {} (must be one of {})", label, in_quotes(text), known));
}

}  // namespace fpkcheck::base
