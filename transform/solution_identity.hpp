#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "problem/model.hpp"

namespace fpkcheck::transform {

/// Type of a solution in a comparison, by increasing trust.
enum class SolutionRole {
  external,    ///< an external density of unknown origin
  closure,     ///< a density of assumed form
  equation,    ///< a discretised density equation
  simulation,  ///< simulated trajectories
};
inline constexpr base::EnumEntry<SolutionRole> kSolutionRoleNames[] = {
    {SolutionRole::external, "given"},
    {SolutionRole::closure, "closure"},
    {SolutionRole::equation, "equation"},
    {SolutionRole::simulation, "simulation"}};
constexpr const auto& enumerator_names(SolutionRole) { return kSolutionRoleNames; }
constexpr std::string_view name(SolutionRole role) { return base::name_of(role); }

/// Colour, line and marker of a solution, the same in all plots and on the report page.
struct PlotStyle {
  std::string colour = "#777777";  ///< colour in the form "#RRGGBB"
  std::string dash = "solid";      ///< a dash type of gnuplot: "solid", "(10,4)"
  double width = 1.5;
  bool as_points = false;    ///< whether points with confidence intervals replace the line
  int layer = 1;             ///< lower layers are drawn first
  std::string symbol = "x";  ///< marker of plotly.js for a single point

  bool operator==(const PlotStyle&) const = default;
};

/// The solver sets the method, the density equation and the impact condition of a solution; the
/// registry of methods sets family, meaning, trust and plot style.
struct SolutionIdentity {
  std::string id;      ///< id of the solution: "epc-gaussian-n6", "fd-kf", "mcs"
  std::string method;  ///< method of the solver: "epc", "fd", "mcs", or "file"
  /// Formulation and variant of a closure, such as "gaussian" or "moment-white"; empty for other
  /// methods.
  std::string formulation = {};
  std::optional<int> order = {};  ///< closure order: degree of its polynomial
  /// Density equation and impact condition that were solved; empty if unknown, for example for a
  /// density from a file.
  std::optional<problem::DensityEquation> equation = {};
  std::optional<problem::ImpactCondition> impact = {};

  SolutionRole role = SolutionRole::external;
  std::string family = {};   ///< group of solutions in lists: "epc-gaussian", "fd"
  std::string meaning = {};  ///< meaning of the method, one sentence for glossaries
  int trust = 0;             ///< rank within the role, by increasing trust
  PlotStyle plot_style = {};

  bool operator==(const SolutionIdentity&) const = default;
};

/// Method names of external densities: "file" for a density from a file, "given" for a density from
/// a function or from samples.
inline constexpr std::string_view kExternalFile = "file", kExternalFunction = "given";

bool is_external(const SolutionIdentity& identity);

/// Returns whether the solutions of the same family differ in their closure order: true for a
/// closure, and for an external density that belongs to a family of external densities
/// (methods/external/external_labels.hpp).
bool differs_by_order_in_family(const SolutionIdentity& identity);

/// Returns the names of the density equation and the impact condition, such as "km4/delta".
std::string equation_and_impact_text(const SolutionIdentity& identity);

/// Returns the short name of a solution within its family, such as "n6" or "kf"; the id if there is
/// no shorter name.
std::string short_name(const SolutionIdentity& identity);

}  // namespace fpkcheck::transform
