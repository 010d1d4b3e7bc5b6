#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>

#include "problem/input_error.hpp"

namespace fpkcheck::cli {

/// The one of the known values that is called so; `name` of an enum is found in its own namespace.
/// @throws InputError naming the option, the value and what is allowed
template <class Enum>
Enum choice(const std::string& value, const char* option, std::initializer_list<Enum> known) {
  std::string names;
  for (const Enum e : known) {
    if (value == name(e)) return e;
    names += (names.empty() ? "" : ", ") + std::string(name(e));
  }
  throw InputError(fmt::format("{} {} (use one of {})", option, value, names));
}

}  // namespace fpkcheck::cli
