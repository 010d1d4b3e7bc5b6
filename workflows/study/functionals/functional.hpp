#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "backward/passage/passage.hpp"
#include "backward/passage/passage_bounds.hpp"
#include "base/options/option_description.hpp"
#include "epc/options.hpp"
#include "fd_fpk/options.hpp"
#include "mcs/options.hpp"
#include "methods/run_cases.hpp"
#include "report/figure/figure.hpp"
#include "results/json_conversions.hpp"
#include "transform/solution.hpp"
#include "workflows/study/study_record.hpp"

/// Options, methods and texts that the commands `spectrum`, `sensitivity` and `passage` share. Each
/// of these commands computes a functional of the generator of the process.
namespace fpkcheck::study {

/// Options that the commands `spectrum`, `sensitivity` and `passage` share.
struct FunctionalCommandOptions {
  std::string methods = "fd-kf,mcs";
  double accuracy = 1e-2;
  double max_seconds = 10;
  std::optional<double> time{};
  std::uint64_t seed = 1;
  std::optional<int> threads{};
};

/// Returns the descriptions `own` of the options of one command, followed by the descriptions of
/// the options in FunctionalCommandOptions.
/// @tparam Options a struct derived from FunctionalCommandOptions
/// @param accuracy_help meaning of the option --accuracy
/// @param time_help meaning of the option --time
/// @param methods_help meaning of the option --methods
template <class Options>
base::OptionsDescription<Options> with_functional_options(
    base::OptionsDescription<Options> own, const std::string& accuracy_help,
    const std::string& time_help,
    const std::string& methods_help =
        "ids of methods: fd-kf, fd-white, fd-km4, "
        ".., mcs, mcs-white") {
  using namespace base;
  const Options defaults;
  const auto member = [](auto FunctionalCommandOptions::*of_base) {
    return static_cast<
        std::remove_reference_t<decltype(std::declval<Options>().*of_base)> Options::*>(of_base);
  };
  return std::move(own)
      .add("methods", member(&FunctionalCommandOptions::methods), {"LIST", methods_help})
      .with_default(defaults.methods)
      .add("accuracy", member(&FunctionalCommandOptions::accuracy), {"A", accuracy_help},
           positive_numbers())
      .with_default(defaults.accuracy)
      .add(
          "max_seconds", member(&FunctionalCommandOptions::max_seconds),
          {"S",
           "time limit in seconds of the finite volumes, of the methods characteristics and bounds, and of each root of a "
           "closure or its density over time"},
          positive_numbers())
      .with_default(defaults.max_seconds)
      .add("time", member(&FunctionalCommandOptions::time), {"T", time_help}, positive_numbers())
      .add("seed", member(&FunctionalCommandOptions::seed), {"N", "seed of the simulation"},
           closed_interval(0, 9.2e18))
      .with_default(static_cast<std::int64_t>(defaults.seed))
      .add("threads", member(&FunctionalCommandOptions::threads),
           {"N", "threads of the simulation (default: one per processor)"},
           closed_interval(1, 4096));
}

/// A method that computes a functional. Exactly one of the members `fd`, `characteristics`,
/// `bounds`, `epc` and `mcs` has a value, the options of the method.
struct SelectedFunctionalMethod {
  transform::SolutionIdentity identity;  ///< with the plot style of the method
  std::optional<fd_fpk::FiniteVolumeOptions> fd = {};
  std::optional<backward::PassageCollocationOptions> characteristics = {};
  std::optional<backward::PassageBoundsOptions> bounds = {};
  std::optional<epc::ClosureOptions> epc = {};
  std::optional<mcs::SimulationOptions> mcs = {};
};

enum class SelectableFunctionalMethods {
  finite_volumes_and_simulations,
  with_closures,
  with_characteristics
};

/// Returns the methods of the comma-separated list FunctionalCommandOptions::methods. The item "fd"
/// selects "fd-kf".
/// @throws InputError if an item selects no method, or a method that is not selectable
std::vector<SelectedFunctionalMethod> methods_selected_by_list(
    const FunctionalCommandOptions& options,
    SelectableFunctionalMethods selectable =
        SelectableFunctionalMethods::finite_volumes_and_simulations);

/// Returns an iterator to the method with the given id, or the end iterator of the list.
std::vector<SelectedFunctionalMethod>::const_iterator find_method(
    const std::vector<SelectedFunctionalMethod>& methods, const std::string& id);

/// Calls `compute` with each selected method. The listener receives the progress of each
/// simulation.
/// @throws InputError as methods_selected_by_list()
void for_each_selected_method(const problem::Problem& problem,
                              const FunctionalCommandOptions& options,
                              const methods::ProgressListener& listener,
                              const std::function<void(const SelectedFunctionalMethod&)>& compute,
                              SelectableFunctionalMethods selectable =
                                  SelectableFunctionalMethods::finite_volumes_and_simulations);

/// Returns the JSON text of one case with a list of results under `key`, as in summary.json.
std::string functional_json(const problem::Problem& problem, const std::string& key,
                            const results::Json& list, const std::string& command);

/// Returns the text "ID: " for a result with the status `ok`, and "ID: STATUS: REASON; " for a
/// result with another status.
std::string solution_status_line(const std::string& id, transform::Status status,
                                 const std::string& reason);

/// Returns the kind of the errors of a result: "discretisation error", "standard error", or
/// "standard error plus error of the kick interval".
std::string error_kind_text(bool has_standard_errors, bool has_kick_interval_errors = false);

/// Appends two table columns of a solution: the values with the path ID, and the errors of the
/// values with the path ID-error.
/// @param has_standard_errors whether the errors are standard errors and nothing else
/// @param format format of the values
void append_value_columns(const std::string& id, const std::string& header,
                          bool has_standard_errors, std::vector<StudyTableColumn>& columns,
                          const char* format = "{:.6g}");

/// Returns a point with an interval of two standard errors, or without an interval if the error is
/// no standard error.
report::FigurePoint figure_point_with_error_interval(double x, double y, double error,
                                                     bool is_standard_error);

/// Returns the items of a comma-separated list.
std::vector<std::string> split_at_commas(const std::string& list);

/// Returns the finite number that a text represents, or an empty value if the text represents no
/// finite number.
std::optional<double> parse_finite_number(const std::string& text);

/// Returns whether at least one result has the status `ok`, and all results have the status `ok` or
/// `not_offered`.
template <class Result>
bool have_converged_results(const std::vector<Result>& results) {
  const auto has_status_ok = [](const Result& result) {
    return result.status == transform::Status::ok;
  };
  const auto is_acceptable = [&](const Result& result) {
    return has_status_ok(result) || result.status == transform::Status::not_offered;
  };
  return std::ranges::all_of(results, is_acceptable) && std::ranges::any_of(results, has_status_ok);
}

/// Returns the results of all methods except closures. Closures may fail, because the accuracy of
/// closures is a result of the command.
template <class Result>
std::vector<Result> without_closures(const std::vector<Result>& results) {
  std::vector<Result> others;
  std::ranges::copy_if(results, std::back_inserter(others),
                       [](const Result& result) { return !result.id.starts_with("epc"); });
  return others;
}

}  // namespace fpkcheck::study
