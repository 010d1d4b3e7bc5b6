#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "problem/model.hpp"

namespace fpkcheck::methods {

/// An argument of the option --against: FILE[:LABEL][,KEY=VALUE]...
struct ExternalArgument {
  std::filesystem::path file;
  std::string label;  ///< label of the density; by default the file name without extension
  bool has_label = true;
  std::optional<problem::DensityEquation> equation = {};
  std::optional<problem::ImpactCondition> impact = {};
  std::optional<int> order = {};  ///< order of the closure
  /// Id of the solution to use, for a file with several solutions.
  std::optional<std::string> solution = {};
  /// Name of the case to use, for a file with several cases.
  std::optional<std::string> case_name = {};
};

/// Parses an argument of the option --against. The name of an existing file is not split, since
/// file names may contain colons and commas.
/// @throws InputError with a message of one line, for an unknown key, an invalid value, or an
///         impact condition without an equation
ExternalArgument parse_external_argument(const std::string& text);

}  // namespace fpkcheck::methods
