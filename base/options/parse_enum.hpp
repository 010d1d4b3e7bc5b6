#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "base/input_error.hpp"
#include "base/options/enum_names.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::base {

/// Converts a name that a user typed to a value of an enum.
/// @param label start of the message: "--design", "plan mine.ini, line 3: design"
/// @param choices names that are accepted
/// @throws InputError when no choice has this name
template <class Enum>
Enum parse_enum(const std::string& label, const std::string& text,
                std::span<const EnumEntry<Enum>> choices = names(Enum{})) {
  std::string known;
  for (const auto& entry : choices) {
    if (entry.name == text) return entry.value;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(fmt::format("{} {} (must be one of {})", label, in_quotes(text), known));
}

}  // namespace fpkcheck::base
