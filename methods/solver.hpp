#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/options/description.hpp"
#include "methods/in_frame.hpp"
#include "methods/method.hpp"

namespace fpkcheck::methods {

/// A family of solutions: its entry in lists, glossaries, legends and the order of trust.
struct Family {
  std::string name;  ///< ids are NAME or begin with NAME-: "epc-gaussian", "fd", "mcs"
  transform::Role role;
  std::string meaning;             ///< one sentence, for glossaries
  std::vector<std::string> usual;  ///< ids that the name selects in a list, by increasing trust
  std::function<transform::PlotStyle(const transform::Identity&)> plot_style;
};

/// A solver: an entry of the registry. The program lists, runs, tabulates, plots, saves, repeats
/// and studies methods through these entries alone.
struct Solver {
  std::string name;                            ///< command, and "method" in files: "epc"
  std::string summary;                         ///< a line of `fpkcheck --help`
  std::string usage;                           ///< first part of `fpkcheck NAME --help`
  std::vector<Family> families;                ///< by increasing trust
  bool parallel = false;                       ///< Method::parallel
  std::vector<std::string> set_by_a_run = {};  ///< names of options that `run` has as well

  const base::DescriptionBase* parameters;  ///< descriptions of the options
  base::Values usual_options;               ///< default values of the options
  /// The options of an id; no value where the id belongs to no solution of this solver.
  std::function<std::optional<base::Values>(std::string_view id)> options_of;
  /// The method with these options.
  /// @throws InputError when the options cannot be read or are invalid
  std::function<Method(const base::Values&)> method;
};

/// The functions of a solver's library from which its registry entry is made.
template <class Options>
struct Front {
  const base::Description<Options>& description;
  /// @throws InputError when the options are invalid
  void (*validate)(const Options&);
  transform::Identity (*identity)(const Options&);
  std::optional<Options> (*options_of)(std::string_view id);
  /// Solves a problem in wall coordinates (problem/frame.hpp), with axes in the same coordinates.
  std::function<transform::Solution(const problem::Problem&, const Options&, const Setting&)> solve;
  /// Method::check; may be null.
  void (*check)(const problem::Problem&, const Options&) = nullptr;
  /// Why the solver does not support a problem, in one phrase; empty where it does. Null where the
  /// solver supports every problem.
  std::string (*objection)(const problem::Problem&, const Options&) = nullptr;
};

/// Completes a registry entry by the solver's functions: converts options to values, and values to
/// methods.
template <class Options>
Solver with_front(Solver solver, const Front<Options>& front) {
  solver.parameters = &front.description;
  solver.usual_options = front.description.values(Options{});
  solver.options_of = [front](std::string_view id) -> std::optional<base::Values> {
    const auto options = front.options_of(id);
    if (!options) return std::nullopt;
    return front.description.values(*options);
  };
  solver.method = [front, parallel = solver.parallel](const base::Values& values) {
    const Options options = front.description.read(values, "options");
    front.validate(options);
    Method method{front.identity(options), front.description.values(options), parallel,
                  [front, options](const problem::Problem& problem, const Setting& setting) {
                    const auto objection = [&](const problem::Problem& seen) {
                      return front.objection == nullptr ? "" : front.objection(seen, options);
                    };
                    return solve_in_frame(
                        problem, setting, objection,
                        [&](const problem::Problem& seen, const Setting& setting_there) {
                          return front.solve(seen, options, setting_there);
                        });
                  }};
    if (front.check != nullptr) {
      method.check = [check = front.check, options](const problem::Problem& problem) {
        check(problem, options);
      };
    }
    return method;
  };
  return solver;
}

}  // namespace fpkcheck::methods
