#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::cli {

struct CommonArguments {
  std::vector<std::string> cases;
  std::vector<std::string> overrides;  ///< values of the option --set, as texts "key=value"
  /// Whether cases may have the section [time]. Only commands that compute densities over time
  /// accept this section.
  problem::TimeSection time_section = problem::TimeSection::refused;
  std::optional<std::string> out;
  bool quiet = false;
  bool json = false;
  report::FigureOptions figures = {};
};

/// Returns a Boost option without a default value. Parsing stores the value of the option in
/// `destination`.
template <class T>
boost::program_options::typed_value<T>* make_optional_option(std::optional<T>& destination,
                                                             const char* placeholder) {
  return boost::program_options::value<T>()
      ->value_name(placeholder)
      ->notifier([&destination](const T& value) { destination = value; });
}

/// Adds the common options --set, --out, --quiet, --json and --help to the options of a command.
boost::program_options::options_description add_common_options(
    const boost::program_options::options_description& command_options, CommonArguments& common,
    const char* out_help =
        "write report.html, summary.json, marginals.csv, smooth.csv, joint.nc and figures/ to DIR "
        "(default: fpkcheck-out for run, else no files)");

/// Adds the output options --out, --quiet, --json and --help to the options of a command with fixed
/// cases.
boost::program_options::options_description add_output_options(
    const boost::program_options::options_description& command_options, CommonArguments& common,
    const char* out_help);

/// Stores the option values in the variables of `options`, and the positional arguments in
/// `positional`. Abbreviated option names are refused.
/// @param usage first lines of the help text
/// @return false if the help was printed because of --help
/// @throws InputError with a message of one line
bool parse_arguments(const std::vector<std::string>& arguments, const std::string& usage,
                     const boost::program_options::options_description& options,
                     std::vector<std::string>& positional);

/// @throws InputError for an invalid case, and for two cases whose results would have the same file
///         name
std::vector<problem::Problem> load_cases(const CommonArguments& common);

}  // namespace fpkcheck::cli
