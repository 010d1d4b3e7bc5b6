#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "problem/equation_and_impact_condition.hpp"

namespace fpkcheck::transform {

/// Types of solutions in a comparison, ordered by increasing trust.
enum class SolutionRole {
  external,    ///< an external density of unknown origin
  closure,     ///< a density of assumed form
  equation,    ///< a discretised density equation
  simulation,  ///< estimates from simulated trajectories
  measurement  ///< an external density that the user chose as the reference
};
inline constexpr base::EnumEntry<SolutionRole> kSolutionRoleNames[] = {
    {SolutionRole::external, "given"},
    {SolutionRole::closure, "closure"},
    {SolutionRole::equation, "equation"},
    {SolutionRole::simulation, "simulation"},
    {SolutionRole::measurement, "measurement"}};
constexpr const auto& enumerator_names(SolutionRole) { return kSolutionRoleNames; }
constexpr std::string_view name(SolutionRole role) { return base::name_of(role); }

/// Colour, line and marker of a solution, the same in all plots and on the report page.
struct PlotStyle {
  std::string colour = "#777777";  ///< colour in the form "#RRGGBB"
  std::string dash = "solid";      ///< a dash type of gnuplot: "solid", "(10,4)"
  double width = 1.5;
  /// Whether plots show the solution as points with confidence intervals instead of a line.
  bool as_points = false;
  int layer = 1;             ///< drawing order: curves of lower layers are drawn first
  std::string symbol = "x";  ///< marker of plotly.js for a single point

  bool operator==(const PlotStyle&) const = default;
};

/// Identity of a solution. The solver sets the method, the density equation and the impact
/// condition, and the registry of methods sets family, meaning, trust and plot style.
struct SolutionIdentity {
  std::string id;      ///< id of the solution: "epc-gaussian-n6", "fd-kf", "mcs"
  std::string method;  ///< name of the method: "epc", "fd", "mcs", or "file"
  /// Formulation and variant of a closure, such as "gaussian" or "moment-white"; empty for methods
  /// other than closures.
  std::string formulation = {};
  std::optional<int> order = {};  ///< closure order: degree of its polynomial
  /// Density equation and impact condition of the solution; empty if unknown, for example for a
  /// density from a file.
  std::optional<problem::DensityEquation> equation = {};
  std::optional<problem::ImpactCondition> impact = {};

  SolutionRole role = SolutionRole::external;
  std::string family = {};   ///< group of solutions in lists: "epc-gaussian", "fd"
  std::string meaning = {};  ///< meaning of the method, one sentence for glossaries
  int trust = 0;  ///< rank among solutions of the same role; a larger rank means more trust
  PlotStyle plot_style = {};

  bool operator==(const SolutionIdentity&) const = default;
};

/// Method names of external densities: "file" for a density from a file, "given" for a density from
/// a function or from samples.
inline constexpr std::string_view kExternalFile = "file", kExternalFunction = "given";

bool is_external(const SolutionIdentity& identity);

/// Returns whether the solutions of a family differ in their closure order: true for closures and
/// for external densities of a family (methods/external/external_labels.hpp).
bool differs_by_order_in_family(const SolutionIdentity& identity);

/// Returns the names of the density equation and the impact condition, such as "km4/delta".
std::string equation_and_impact_text(const SolutionIdentity& identity);

/// Returns the short name of a solution within its family, such as "n6" or "kf". The name of a
/// solution without a shorter name is the id of the solution.
std::string solution_name_within_family(const SolutionIdentity& identity);

}  // namespace fpkcheck::transform
