#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fpkcheck::problem {

/// What the program does not treat, and the words by which it is asked for in keys of case files and
/// in commands.
struct Untreated {
  std::string_view subject;                 ///< "dry friction"
  std::span<const std::string_view> words;  ///< lower case; of a key any part between '.' and '_'
};

/// All of it, as README.md lists it.
std::span<const Untreated> untreated();

/// One line that says what a key or a command asks for that is not treated, and where the list is;
/// empty where it asks for nothing of that kind.
/// @param name "system.friction", "passage"
std::string untreated_text(std::string_view name);

}  // namespace fpkcheck::problem
