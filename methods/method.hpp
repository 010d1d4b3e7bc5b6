#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/options/description.hpp"
#include "base/options/parameter.hpp"
#include "compare/comparison_axes.hpp"
#include "methods/residual_error_estimator.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// Function that receives the completed fraction, 0 .. 1, of the work of a method, and a note on
/// the state of the method. The note may be empty.
using ProgressCallback = std::function<void(double, const std::string& note)>;

/// The input of a method in addition to the problem.
struct SolveContext {
  const compare::ComparisonAxes& axes;  ///< comparison bins, which a simulation's histogram uses
  const ProgressCallback& progress;     ///< receives the progress of the method; may be empty
  /// Residual-based error estimator of the problem, for methods that do not estimate their errors
  /// otherwise (set_residual_error_estimate). Null if the caller has no estimator to share.
  const ResidualErrorEstimator* error_estimator = nullptr;
  /// Whether the method must estimate the error of its solution. False if the caller estimates the
  /// error, as by the distance from the reference.
  bool estimate_error = true;
};

/// A solver together with values of its options.
struct Method {
  transform::SolutionIdentity identity;  ///< identity of the solutions of this method
  base::Values options = {};             ///< values of the options, as stored in files
  /// Whether the method uses all processors. No other method should run at the same time.
  bool uses_all_processors = false;
  /// Solves a problem. The caller sets the identity and options of the solution (solve_with).
  std::function<transform::Solution(const problem::Problem&, const SolveContext&)> solve;
  /// Tests whether the options and a problem are compatible. All tests run before the first problem
  /// is solved. May be empty.
  /// @throws InputError when the options and the problem are incompatible
  std::function<void(const problem::Problem&)> check = {};

  const std::string& id() const { return identity.id; }
};

/// Solves a problem in wall coordinates (problem/walls.hpp), in which the wall is at 0, and returns
/// the solution in physical coordinates. If the solver does not support the problem, the status of
/// the solution is `not_offered`, and its reason is the result of `unsupported_reason`.
/// @param unsupported_reason function of the transformed problem that returns the reason why the
///        solver does not support the problem; an empty reason if the solver supports the problem
/// @param solve function that solves the transformed problem on the transformed axes
transform::Solution solve_in_wall_coordinates(
    const problem::Problem& problem, const SolveContext& context,
    const std::function<std::string(const problem::Problem&)>& unsupported_reason,
    const std::function<transform::Solution(const problem::Problem&, const SolveContext&)>& solve);

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

  const base::DescriptionBase* option_descriptions = nullptr;  ///< descriptions of the options
  base::Values default_options = {};                           ///< default values of the options
  /// Function that returns the options of the method with an id; empty if the solver has no method
  /// with this id.
  std::function<std::optional<base::Values>(std::string_view id)> options_of = {};
  /// Function that returns the method with the given options.
  /// @throws InputError when the options cannot be read or are invalid
  std::function<Method(const base::Values&)> method = {};
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
  /// Solves a problem in wall coordinates (problem/walls.hpp), with axes in the same coordinates.
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
