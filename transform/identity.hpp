#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/options/names.hpp"
#include "problem/model.hpp"

namespace fpkcheck::transform {

/// What part a solution plays in a comparison, by increasing trust.
enum class Role {
  given,       ///< brought along: nothing is known of how it came about
  closure,     ///< a density of assumed form
  equation,    ///< a density equation, discretised
  simulation,  ///< the trajectories themselves
};
inline constexpr base::Named<Role> kRoleNames[] = {{Role::given, "given"},
                                                   {Role::closure, "closure"},
                                                   {Role::equation, "equation"},
                                                   {Role::simulation, "simulation"}};
constexpr std::span<const base::Named<Role>> names(Role) { return kRoleNames; }
constexpr std::string_view name(Role role) { return base::name_of(role); }

/// How a solution looks in every picture and on the page.
struct Look {
  std::string colour = "#777777";  ///< "#RRGGBB"
  std::string dash = "solid";      ///< a dash type of gnuplot: "solid", "(10,4)"
  double width = 1.5;
  bool as_points = false;    ///< hollow points with intervals instead of a line
  int layer = 1;             ///< lower layers are drawn first
  std::string symbol = "x";  ///< where it is a single point: a marker of plotly.js

  bool operator==(const Look&) const = default;
};

/// Which solution this is. A solver fills in what it solved; the registry of methods adds what
/// tells it from others.
struct Identity {
  std::string id;      ///< e.g. "epc-gaussian-n6", "fd-kf", "mcs"
  std::string method;  ///< the solver: "epc", "fd", "mcs", "file"
  /// Of a closure, with its variant: "gaussian", "moment-white"; else empty.
  std::string formulation = {};
  std::optional<int> order = {};  ///< of a closure's polynomial
  /// Nothing where nobody knows (a file).
  std::optional<problem::Equation> equation = {};
  std::optional<problem::Impact> impact = {};

  Role role = Role::given;
  std::string family = {};   ///< what it is listed under: "epc-gaussian", "fd", "mcs"
  std::string meaning = {};  ///< one sentence, for glossaries
  int trust = 0;             ///< place in the order of trust, within the role
  Look look = {};

  bool operator==(const Identity&) const = default;
};

/// Methods that solve nothing: a density that somebody brought along, in a file, or as a function
/// or samples.
inline constexpr std::string_view kGivenInFile = "file", kGivenAsFunction = "given";

/// A density that somebody brought along: what a user came to see, whatever its role.
bool is_guest(const Identity& identity);

/// A member of a family that differs by its order: a closure, or a density that somebody brought along
/// with others of its family (methods/external/families.hpp).
bool is_by_order(const Identity& identity);

/// "km4/delta" in tables: the equation that was solved, and its impact; "given/-" where nobody
/// knows.
std::string solves_text(const Identity& identity);

/// What tells the members of a family apart: "n6", "kf"; the id where there is nothing else.
std::string short_name(const Identity& identity);

}  // namespace fpkcheck::transform
