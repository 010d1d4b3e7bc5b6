#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::problem {

/// A case file that is compiled into the program.
struct BuiltInCase {
  std::string name;
  std::string text;  ///< the contents of cases/NAME.ini
};

/// The four cases of Table 1 of the paper, in the order of the table.
const std::vector<BuiltInCase>& paper_cases();

/// Example oscillators. Each example is the simplest oscillator of its type in docs/systems.md.
const std::vector<BuiltInCase>& example_systems();

/// The case with this name that is compiled into the program; null if there is none.
const BuiltInCase* find_built_in_case(std::string_view name);

}  // namespace fpkcheck::problem
