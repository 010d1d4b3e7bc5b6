#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/option_description.hpp"
#include "base/options/parameter_value.hpp"
#include "compare/comparison_bins.hpp"
#include "methods/residual_error_estimator.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// Function that receives the completed fraction (0 .. 1) of the work of a method, and a note on
/// the progress of the method, which may be empty.
using ProgressCallback = std::function<void(double, const std::string& note)>;

/// The input that a method receives in addition to the problem.
struct SolverInputContext {
  const compare::ComparisonBins& axes;  ///< comparison bins, used for the histogram of a simulation
  const ProgressCallback& progress;
  /// Residual-based error estimator (set_residual_error_estimate), for methods that have no other
  /// error estimate. The pointer error_estimator may be null.
  const ResidualErrorEstimator* error_estimator = nullptr;
  /// Whether the method must estimate the error of its solution. The flag `estimate_error` is false
  /// if the caller estimates the error of the solution, for example from the distance to the
  /// reference.
  bool estimate_error = true;
};

/// A method: a solver together with values of its options.
struct Method {
  transform::SolutionIdentity identity;  ///< identity of the solutions
  base::Values options = {};             ///< values of the options, as stored in files
  /// Whether the method uses all processors; while such a method runs, no other method runs.
  bool uses_all_processors = false;
  /// Function that solves a problem. The caller solve_with_method() sets the identity and options
  /// of the solution.
  std::function<transform::Solution(const problem::Problem&, const SolverInputContext&)> solve;
  /// Optional function that checks, before the first solve, that the options and a problem are
  /// compatible.
  /// @throws InputError if the options and the problem are incompatible
  std::function<void(const problem::Problem&)> check = {};
  /// Optional function that returns the options of an identical equation of the solver for a
  /// problem; empty if the solver does not support the problem. Methods of one solver with equal
  /// options of the identical equation have equal solutions.
  std::function<std::optional<base::Values>(const problem::Problem&)>
      options_of_identical_equation = {};

  const std::string& id() const { return identity.id; }
};

/// Returns the problem in wall coordinates (problem/walls.hpp), in which the first wall is at 0.
problem::Problem to_wall_coordinates(const problem::Problem& problem);

/// Solves a problem in wall coordinates (problem/walls.hpp), in which the first wall is at 0, and
/// returns the solution in physical coordinates. If the solver does not support the problem, the
/// status of the solution is `not_offered`.
/// @param unsupported_reason function that returns why the solver does not support the transformed
/// problem; an empty text for a supported problem. The text of unsupported_reason() becomes the
/// reason of the status of the solution.
/// @param solve function that solves the transformed problem on the transformed comparison axes
transform::Solution solve_in_wall_coordinates(
    const problem::Problem& problem, const SolverInputContext& context,
    const std::function<std::string(const problem::Problem&)>& unsupported_reason,
    const std::function<transform::Solution(const problem::Problem&, const SolverInputContext&)>&
        solve);

/// Sets the residual-based error estimate of a closure (set_residual_error_estimate()) if the
/// context requires an error estimate and the solution has a density.
/// @param problem problem in the coordinates of the solution
/// @param accuracy largest admissible L1 error of p(y) and of p(y')
void set_closure_error_estimate(const SolverInputContext& context, const problem::Problem& problem,
                                double accuracy, transform::Solution& solution);

/// A family of methods of one solver, with a common name, meaning and plot style. Lists of methods,
/// glossaries and legends have one entry for each family of methods.
struct MethodFamily {
  /// Name of the family: "epc-gaussian", "fd" or "mcs". The ids of the members are NAME or begin
  /// with NAME-.
  std::string name;
  transform::SolutionRole role;  ///< role of the solutions in comparisons
  std::string meaning;           ///< one sentence on the methods of the family, for glossaries
  /// Ids of the methods that the family name selects in a list of methods, by increasing trust.
  std::vector<std::string> default_ids;
  std::function<transform::PlotStyle(const transform::SolutionIdentity&)> plot_style;
};

/// A solver as an entry of the registry of solvers. All commands of the program use solvers only
/// through entries of the registry.
struct Solver {
  std::string name;     ///< name of the solver's command, and value of "method" in files: "epc"
  std::string summary;  ///< description in one line for `fpkcheck --help`
  std::string usage;    ///< first part of `fpkcheck NAME --help`
  std::vector<MethodFamily> families;  ///< families of methods, by increasing trust
  bool uses_all_processors = false;
  /// Whether a run includes the solver without the option --methods.
  bool in_default_runs = true;
  /// Names of the options of the solver that the command `run` accepts.
  std::vector<std::string> run_options = {};

  const base::OptionsDescriptionBase* option_descriptions = nullptr;
  base::Values default_options = {};
  /// Returns the options of the method with an id; empty if the solver has no method with this id.
  std::function<std::optional<base::Values>(std::string_view id)> options_of = {};
  /// @throws InputError if the options cannot be read or are invalid
  std::function<Method(const base::Values&)> method = {};
};

/// Functions of the library of a solver, for registry_entry_with_solver_traits().
template <class Options>
struct SolverLibraryFunctions {
  const base::OptionsDescription<Options>& description;
  /// @throws InputError if the options are invalid
  void (*validate)(const Options&);
  transform::SolutionIdentity (*identity)(const Options&);
  /// Returns the options of the method with an id; empty if the solver has no method with this id.
  std::optional<Options> (*options_of)(std::string_view id);
  /// Function that solves a problem in wall coordinates (problem/walls.hpp), with comparison axes
  /// in wall coordinates.
  std::function<transform::Solution(const problem::Problem&, const Options&,
                                    const SolverInputContext&)>
      solve;
  /// Function for Method::check, which checks that a problem and the options are compatible; may be
  /// null.
  void (*check)(const problem::Problem&, const Options&) = nullptr;
  /// Function that returns the reason why the solver does not support a problem, or an empty text.
  /// If the pointer unsupported_reason is null, the solver supports every problem.
  std::string (*unsupported_reason)(const problem::Problem&, const Options&) = nullptr;
  /// Function for Method::options_of_identical_equation, for a problem in wall coordinates; may be
  /// null.
  std::optional<Options> (*options_of_identical_equation)(const problem::Problem&,
                                                          const Options&) = nullptr;
};

/// Returns a copy of a registry entry, completed with the option descriptions, default options and
/// functions of the solver's library.
template <class Options>
Solver registry_entry_with_solver_traits(Solver solver,
                                         const SolverLibraryFunctions<Options>& traits) {
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
        [traits, options](const problem::Problem& problem, const SolverInputContext& context) {
          const auto unsupported_reason = [&](const problem::Problem& transformed) {
            return traits.unsupported_reason == nullptr
                       ? ""
                       : traits.unsupported_reason(transformed, options);
          };
          return solve_in_wall_coordinates(problem, context, unsupported_reason,
                                           [&](const problem::Problem& transformed,
                                               const SolverInputContext& transformed_context) {
                                             return traits.solve(transformed, options,
                                                                 transformed_context);
                                           });
        }};
    if (traits.check != nullptr) {
      method.check = [check = traits.check, options](const problem::Problem& problem) {
        check(problem, options);
      };
    }
    if (traits.options_of_identical_equation != nullptr) {
      method.options_of_identical_equation =
          [traits, options](const problem::Problem& problem) -> std::optional<base::Values> {
        const auto identical =
            traits.options_of_identical_equation(to_wall_coordinates(problem), options);
        if (!identical) return std::nullopt;
        return traits.description.values(*identical);
      };
    }
    return method;
  };
  return solver;
}

}  // namespace fpkcheck::methods
