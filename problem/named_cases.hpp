#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::problem {

/// A case file that is compiled into the program.
struct BuiltinCase {
  std::string name;
  std::string text;  ///< the contents of cases/NAME.ini
};

/// The four cases of the paper (Table 1), in its order.
const std::vector<BuiltinCase>& paper_cases();

/// Example oscillators, each the smallest of its kind (docs/systems.md).
const std::vector<BuiltinCase>& example_systems();

/// The compiled-in case with this name; null when there is none.
const BuiltinCase* find_builtin_case(std::string_view name);

}  // namespace fpkcheck::problem
