#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/options/enum_names.hpp"
#include "problem/equation_and_impact_condition.hpp"

namespace fpkcheck::methods {

/// The relation between the samples of a file.
enum class SampleRelation {
  independent,
  series,  ///< successive states of one trajectory at equal time intervals
};
inline constexpr base::EnumEntry<SampleRelation> kSampleRelationNames[] = {
    {SampleRelation::independent, "independent"}, {SampleRelation::series, "series"}};
constexpr const auto& enumerator_names(SampleRelation) { return kSampleRelationNames; }

/// An argument FILE[:LABEL][,KEY=VALUE].. of the option --against.
struct ExternalDensityArgument {
  std::filesystem::path file;
  std::string label;  ///< label of the density; by default the file name without extension
  bool has_label = true;
  std::optional<problem::DensityEquation> equation = {};
  std::optional<problem::ImpactCondition> impact = {};
  std::optional<int> order = {};  ///< closure order of the density, if known
  /// Relation between the samples, if the file has samples of y, or of y and y', in place of a
  /// density.
  std::optional<SampleRelation> samples = {};
  bool is_reference = false;  ///< whether all solutions are compared with this density
  /// Id of the solution to use, if the density file has several solutions.
  std::optional<std::string> solution = {};
  /// Name of the case to use, if the density file has several cases.
  std::optional<std::string> case_name = {};
};

/// Parses an argument of the option --against. If the whole argument is the name of an existing
/// file, the argument is not split at colons and commas.
/// @throws InputError with a message of one line, for an unknown key, an invalid value, an
/// impact condition without a density equation, or a reference with a density equation
ExternalDensityArgument parse_external_argument(const std::string& text);

}  // namespace fpkcheck::methods
