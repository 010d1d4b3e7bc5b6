#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "problem/model.hpp"

namespace fpkcheck::methods {

/// An argument of --against: FILE[:LABEL][,KEY=VALUE]...
struct ExternalArgument {
  std::filesystem::path file;
  std::string label;      ///< the file's stem by default
  bool has_label = true;  ///< whether the argument has a label
  std::optional<problem::Equation> equation = {};
  std::optional<problem::Impact> impact = {};
  std::optional<int> order = {};
  std::optional<std::string> solution = {};   ///< in a file with several solutions
  std::optional<std::string> case_name = {};  ///< in a file with several cases
};

/// Parses an argument. File names may contain colons and commas: the name of an existing file is
/// not split.
/// @throws InputError on one line: an unknown key, an invalid value, an impact without an equation
ExternalArgument parse_external_argument(const std::string& text);

}  // namespace fpkcheck::methods
