#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "problem/equation_and_impact_condition.hpp"

namespace fpkcheck::methods {

/// An argument FILE[:LABEL][,KEY=VALUE].. of the option --against.
struct ExternalDensityArgument {
  std::filesystem::path file;
  std::string label;  ///< label of the density; by default the file name without extension
  bool has_label = true;
  std::optional<problem::DensityEquation> equation = {};
  std::optional<problem::ImpactCondition> impact = {};
  std::optional<int> order = {};  ///< closure order of the density, if known
  /// Id of the solution to use, if the density file has several solutions.
  std::optional<std::string> solution = {};
  /// Name of the case to use, if the density file has several cases.
  std::optional<std::string> case_name = {};
};

/// Parses an argument of the option --against. If the whole argument is the name of an existing
/// file, the argument is not split at colons and commas.
/// @throws InputError with a message of one line, for an unknown key, an invalid value, or an
/// impact condition without a density equation
ExternalDensityArgument parse_external_argument(const std::string& text);

}  // namespace fpkcheck::methods
