#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/registry.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::cli {

/// Splits a comma-separated list; returns its distinct entries in the order of the list.
/// @param option name of the option, for error messages
/// @throws InputError for an empty list
std::vector<std::string> parse_list(const std::string& option, const std::string& list);

/// Parses a comma-separated list of whole numbers; returns the distinct numbers in the order of the
/// list.
/// @throws InputError for an empty list or an item that is not an integer
std::vector<int> parse_integers(const std::string& option, const std::string& list);

/// Command-line options of all described parameters that have a flag. The description of a
/// parameter supplies the help text, default and range of its option. An option on the command line
/// replaces the value of the parameter in `values`.
/// @param values values of all parameters, in any order; stored by reference
/// @throws InputError during parsing; the message names the flag, its text and the allowed values
boost::program_options::options_description make_command_line_options(
    const base::DescriptionBase& description, base::Values& values);

/// Command-line options of the parameters in `names`, without defaults. The options that are on the
/// command line are added to `given`.
boost::program_options::options_description make_command_line_options(
    const base::DescriptionBase& description, const std::vector<std::string>& names,
    base::Values& given);

/// Command-line options of solvers that a command with many methods accepts
/// (methods::Solver::run_options).
boost::program_options::options_description make_run_options(const methods::Registry& registry,
                                                             base::Values& given);

/// Number of threads for methods that run in parallel, from --threads; 0 without this option.
int requested_thread_count(const base::Values& given);

/// Description of the options --figures and --figure-width.
/// @param figures receives the parsed values; stored by reference
/// @throws InputError during parsing; the message names the option, its text and the allowed values
boost::program_options::options_description make_figure_options(report::FigureOptions& figures);

/// Description of the options --figures, --figure-width and --curves, for the figures of a case.
boost::program_options::options_description make_case_figure_options(
    report::FigureOptions& figures);

}  // namespace fpkcheck::cli
