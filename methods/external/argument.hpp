#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "problem/model.hpp"

namespace fpkcheck::methods {

/// What is said of a file of a density: FILE[:LABEL][,KEY=VALUE]...
struct GivenArgument {
  std::filesystem::path file;
  std::string label;      ///< the file's stem where none is given
  bool own_label = true;  ///< false where none is given
  std::optional<problem::Equation> equation = {};
  std::optional<problem::Impact> impact = {};
  std::optional<int> order = {};
  std::optional<std::string> solution = {};   ///< of a file that holds several
  std::optional<std::string> case_name = {};  ///< of a file that holds several
};

/// A file's name may have colons and commas itself: what is a file is not split.
/// @throws InputError on one line: an unknown key, a value that it cannot have, an impact without
///         an equation
GivenArgument given_argument(const std::string& text);

}  // namespace fpkcheck::methods
