#pragma once

#include <boost/program_options.hpp>

#include <optional>
#include <string>
#include <vector>

#include "base/options/option_description.hpp"
#include "methods/registry.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure_options.hpp"

namespace fpkcheck::cli {

struct CommonCommandArguments {
  std::vector<std::string> cases;
  std::vector<std::string> overrides;  ///< values of the option --set, as texts "key=value"
  /// Whether case files may have the section [time] (an excitation that changes in time). Only
  /// commands that compute densities over time accept the section [time].
  problem::CaseFileTimeSectionPolicy time_section = problem::CaseFileTimeSectionPolicy::refused;
  std::optional<std::string> out;
  bool quiet = false;
  bool json = false;
  report::FigureOptions figures = {};
};

/// Returns a Boost command-line option without a default value. Parsing stores the value of a
/// command-line option in `destination`.
template <class T>
boost::program_options::typed_value<T>* make_optional_option(std::optional<T>& destination,
                                                             const char* placeholder) {
  return boost::program_options::value<T>()
      ->value_name(placeholder)
      ->notifier([&destination](const T& value) { destination = value; });
}

/// Adds the output options --out, --quiet, --json and --help to the options of a command with fixed
/// cases, such as `paper`.
boost::program_options::options_description add_output_options(
    const boost::program_options::options_description& command_options,
    CommonCommandArguments& common, const char* out_help);

/// Parses the arguments of a command: stores the option values in the variables of `options`, and
/// the positional arguments in `positional`. Abbreviated option names are refused.
/// @param usage first lines of the help text
/// @return false if the help was printed because of --help
/// @throws InputError with a message of one line
bool parse_arguments(const std::vector<std::string>& arguments, const std::string& usage,
                     const boost::program_options::options_description& options,
                     std::vector<std::string>& positional);

/// Parses the arguments of a command with cases: the options of the command, and the common options
/// --set, --out, --quiet, --json and --help.
/// @return false if the help was printed because of --help
/// @throws InputError with a message of one line
bool parse_case_arguments(
    const std::vector<std::string>& arguments, const std::string& usage,
    const boost::program_options::options_description& command_options,
    CommonCommandArguments& common,
    const char* out_help =
        "write report.html, summary.json, marginals.csv, smooth.csv, joint.nc and figures/ to DIR "
        "(default: fpkcheck-out for run, else no files)");

/// @throws InputError for an invalid case, and for two cases whose results would have the same file
///         name
std::vector<problem::Problem> load_cases(const CommonCommandArguments& common);

/// Returns the distinct entries of a comma-separated list, in the order of the list.
/// @param option name of the option, for error messages
/// @throws InputError for an empty list
std::vector<std::string> parse_comma_separated_list(const std::string& option,
                                                    const std::string& list);

/// Returns the distinct integers of a comma-separated list, in the order of the list.
/// @throws InputError for an empty list or an item that is not an integer
std::vector<int> parse_integers(const std::string& option, const std::string& list);

/// Makes a command-line option for each parameter in `description` that has a flag. Parsing
/// replaces elements of `values` by the values on the command line.
/// @param values values of all parameters, in any order; the options keep a reference to `values`
/// @throws InputError during parsing, with the flag, the refused text and the allowed values
boost::program_options::options_description make_command_line_options(
    const base::OptionsDescriptionBase& description, base::Values& values);

/// Makes command-line options without default values for the parameters in `names`. Parsing stores
/// the options that occur on the command line in `given`.
boost::program_options::options_description make_command_line_options(
    const base::OptionsDescriptionBase& description, const std::vector<std::string>& names,
    base::Values& given);

/// Makes the options of solvers (methods::Solver::run_options) for commands that use several
/// methods.
boost::program_options::options_description make_solver_run_options(
    const methods::SolverRegistry& registry, base::Values& given);

/// Returns the number of threads for parallel methods: the value of --threads, or 0 without this
/// option.
int requested_thread_count(const base::Values& given);

/// Makes the options --figures and --figure-width.
/// @param figures receives the parsed values; the options keep a reference to `figures`
/// @throws InputError during parsing, with the option, the refused text and the allowed values
boost::program_options::options_description make_figure_options(report::FigureOptions& figures);

/// Makes the options --figures, --figure-width and --curves for the figures of a case.
boost::program_options::options_description make_case_figure_options(
    report::FigureOptions& figures);

}  // namespace fpkcheck::cli
