#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "problem/model.hpp"

namespace fpkcheck::transform {

/// Kind of a solution in a comparison, by increasing trust.
enum class Role {
  external,    ///< an external density of unknown origin
  closure,     ///< a density of assumed form
  equation,    ///< a discretised density equation
  simulation,  ///< simulated trajectories
};
inline constexpr base::EnumEntry<Role> kRoleNames[] = {{Role::external, "given"},
                                                       {Role::closure, "closure"},
                                                       {Role::equation, "equation"},
                                                       {Role::simulation, "simulation"}};
constexpr std::span<const base::EnumEntry<Role>> names(Role) { return kRoleNames; }
constexpr std::string_view name(Role role) { return base::name_of(role); }

/// Colours and lines of a solution in every plot and on the page.
struct PlotStyle {
  std::string colour = "#777777";  ///< "#RRGGBB"
  std::string dash = "solid";      ///< a dash type of gnuplot: "solid", "(10,4)"
  double width = 1.5;
  bool as_points = false;    ///< hollow points with intervals instead of a line
  int layer = 1;             ///< lower layers are drawn first
  std::string symbol = "x";  ///< marker of plotly.js for a single point

  bool operator==(const PlotStyle&) const = default;
};

/// Identification of a solution. The solver sets the method, the equation and the impact; the
/// registry of methods adds family, meaning, trust and plot style.
struct Identity {
  std::string id;      ///< e.g. "epc-gaussian-n6", "fd-kf", "mcs"
  std::string method;  ///< solver: "epc", "fd", "mcs", or "file"
  /// Formulation of a closure, with its variant: "gaussian", "moment-white"; else empty.
  std::string formulation = {};
  std::optional<int> order = {};  ///< degree of the closure's polynomial
  /// Equation and impact that were solved; empty if unknown (a file).
  std::optional<problem::Equation> equation = {};
  std::optional<problem::Impact> impact = {};

  Role role = Role::external;
  std::string family = {};   ///< group in lists: "epc-gaussian", "fd", "mcs"
  std::string meaning = {};  ///< one sentence for glossaries
  int trust = 0;             ///< rank within the role, by increasing trust
  PlotStyle plot_style = {};

  bool operator==(const Identity&) const = default;
};

/// Method names of external densities: from a file, or from a function or samples.
inline constexpr std::string_view kExternalFile = "file", kExternalFunction = "given";

/// True for an external density, whatever its role.
bool is_external(const Identity& identity);

/// True if the members of the solution's family differ by their order: a closure, or an external
/// density with a family of its own (methods/external/families.hpp).
bool is_distinguished_by_order(const Identity& identity);

/// Equation and impact that were solved, by their names in files: "km4/delta".
std::string equation_and_impact_text(const Identity& identity);

/// Name within the family: "n6", "kf"; the id if there is no shorter name.
std::string short_name(const Identity& identity);

}  // namespace fpkcheck::transform
