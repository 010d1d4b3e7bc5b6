#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "base/input_error.hpp"
#include "base/options/names.hpp"
#include "base/text/shown.hpp"

namespace fpkcheck::base {

/// The value of an enum that a user asked for by its name.
/// @param what how the message begins: "--design", "plan mine.ini, line 3: design"
/// @param among those that may be asked for
/// @throws InputError when there is none of this name
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
