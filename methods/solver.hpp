#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/options/description.hpp"
#include "methods/method.hpp"
#include "methods/solve_in_wall_coordinates.hpp"

namespace fpkcheck::methods {

/// A family of methods: methods of one solver that share a name, a meaning and a plot style. Lists
/// of methods, glossaries and legends have one entry for each family.
struct MethodFamily {
  /// Name of the family: "epc-gaussian", "fd", "mcs". The ids of the members are NAME or begin with
  /// NAME-.
  std::string name;
  transform::SolutionRole role;  ///< role of the solutions in comparisons
  std::string meaning;           ///< one sentence on the methods of the family, for glossaries
  /// Ids of the methods that the family name selects in a list of methods, by increasing trust.
  std::vector<std::string> default_ids;
  /// Function that returns the plot style of a solution of the family.
  std::function<transform::PlotStyle(const transform::SolutionIdentity&)> plot_style;
};

/// A solver, an entry of the registry. All commands of the program use solvers through their
/// registry entries only.
struct Solver {
  std::string name;                    ///< name of the command, and "method" in files: "epc"
  std::string summary;                 ///< a line of `fpkcheck --help`
  std::string usage;                   ///< first part of `fpkcheck NAME --help`
  std::vector<MethodFamily> families;  ///< families of methods of the solver, by increasing trust
  bool uses_all_processors = false;    ///< whether the methods use all processors
  /// Names of the solver's options that the command `run` also accepts.
  std::vector<std::string> run_options = {};

  const base::DescriptionBase* option_descriptions;  ///< descriptions of the options
  base::Values default_options;                      ///< default values of the options
  /// Function that returns the options of the method with an id; empty if the solver has no method
  /// with this id.
  std::function<std::optional<base::Values>(std::string_view id)> options_of;
  /// Function that returns the method with the given options.
  /// @throws InputError when the options cannot be read or are invalid
  std::function<Method(const base::Values&)> method;
};

/// The functions of a solver's library that with_traits() uses for the registry entry of the
/// solver.
template <class Options>
struct SolverTraits {
  const base::Description<Options>& description;  ///< description of the options
  /// Tests the options.
  /// @throws InputError when the options are invalid
  void (*validate)(const Options&);
  /// The identity of the solutions of the solver with these options.
  transform::SolutionIdentity (*identity)(const Options&);
  /// The options of the method with an id; empty if the solver has no method with this id.
  std::optional<Options> (*options_of)(std::string_view id);
  /// Solves a problem in wall coordinates (problem/frame.hpp), with axes in the same coordinates.
  std::function<transform::Solution(const problem::Problem&, const Options&, const SolveContext&)>
      solve;
  /// Tests whether a problem and the options are compatible, as Method::check; may be null.
  void (*check)(const problem::Problem&, const Options&) = nullptr;
  /// The reason why the solver does not support a problem, in one phrase; empty if the solver
  /// supports the problem. A null function means that the solver supports every problem.
  std::string (*unsupported_reason)(const problem::Problem&, const Options&) = nullptr;
};

/// A copy of a registry entry in which the option descriptions, the default options and the
/// functions are those of the solver's library.
template <class Options>
Solver with_traits(Solver solver, const SolverTraits<Options>& traits) {
  solver.option_descriptions = &traits.description;
  solver.default_options = traits.description.values(Options{});
  solver.options_of = [traits](std::string_view id) -> std::optional<base::Values> {
    const auto options = traits.options_of(id);
    if (!options) return std::nullopt;
    return traits.description.values(*options);
  };
  solver.method = [traits,
                   uses_all_processors = solver.uses_all_processors](const base::Values& values) {
    const Options options = traits.description.read(values, "options");
    traits.validate(options);
    Method method{
        traits.identity(options), traits.description.values(options), uses_all_processors,
        [traits, options](const problem::Problem& problem, const SolveContext& context) {
          const auto unsupported_reason = [&](const problem::Problem& transformed) {
            return traits.unsupported_reason == nullptr
                       ? ""
                       : traits.unsupported_reason(transformed, options);
          };
          return solve_in_wall_coordinates(
              problem, context, unsupported_reason,
              [&](const problem::Problem& transformed, const SolveContext& transformed_context) {
                return traits.solve(transformed, options, transformed_context);
              });
        }};
    if (traits.check != nullptr) {
      method.check = [check = traits.check, options](const problem::Problem& problem) {
        check(problem, options);
      };
    }
    return method;
  };
  return solver;
}

}  // namespace fpkcheck::methods
