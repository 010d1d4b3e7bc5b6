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

/// A family of solutions: its entry in lists, glossaries, legends and the order of trust.
struct Family {
  std::string name;  ///< ids are NAME or begin with NAME-: "epc-gaussian", "fd", "mcs"
  transform::Role role;
  std::string meaning;  ///< one sentence, for glossaries
  std::vector<std::string>
      default_ids;  ///< ids that the name selects in a list, by increasing trust
  std::function<transform::PlotStyle(const transform::Identity&)> plot_style;
};

/// A solver: an entry of the registry. The program lists, runs, tabulates, plots, saves, repeats
/// and studies methods through these entries alone.
struct Solver {
  std::string name;                           ///< command, and "method" in files: "epc"
  std::string summary;                        ///< a line of `fpkcheck --help`
  std::string usage;                          ///< first part of `fpkcheck NAME --help`
  std::vector<Family> families;               ///< by increasing trust
  bool uses_all_processors = false;           ///< Method::uses_all_processors
  std::vector<std::string> run_options = {};  ///< names of options that `run` has as well

  const base::DescriptionBase* option_descriptions;  ///< descriptions of the options
  base::Values default_options;                      ///< default values of the options
  /// The options of an id; no value where the id belongs to no solution of this solver.
  std::function<std::optional<base::Values>(std::string_view id)> options_of;
  /// The method with these options.
  /// @throws InputError when the options cannot be read or are invalid
  std::function<Method(const base::Values&)> method;
};

/// The functions of a solver's library from which its registry entry is made.
template <class Options>
struct SolverTraits {
  const base::Description<Options>& description;
  /// @throws InputError when the options are invalid
  void (*validate)(const Options&);
  transform::Identity (*identity)(const Options&);
  std::optional<Options> (*options_of)(std::string_view id);
  /// Solves a problem in wall coordinates (problem/frame.hpp), with axes in the same coordinates.
  std::function<transform::Solution(const problem::Problem&, const Options&, const SolveContext&)>
      solve;
  /// Method::check; may be null.
  void (*check)(const problem::Problem&, const Options&) = nullptr;
  /// Why the solver does not support a problem, in one phrase; empty where it does. Null where the
  /// solver supports every problem.
  std::string (*unsupported_reason)(const problem::Problem&, const Options&) = nullptr;
};

/// Completes a registry entry by the solver's functions: converts options to values, and values to
/// methods.
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
