#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "base/input_error.hpp"
#include "base/options/names.hpp"
#include "base/text/shown.hpp"

namespace fpkcheck::base {

/// Converts a name that a user typed to a value of an enum.
/// @param label start of the message: "--design", "plan mine.ini, line 3: design"
/// @param choices names that are accepted
/// @throws InputError when no choice has this name
template <class Enum>
Enum asked_name(const std::string& what, const std::string& text,
                std::span<const Named<Enum>> among = names(Enum{})) {
  std::string known;
  for (const auto& entry : among) {
    if (entry.name == text) return entry.value;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(fmt::format("{} {} (must be one of {})", what, in_quotes(text), known));
}

}  // namespace fpkcheck::base
