#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/registry.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::cli {

/// Returns the distinct entries of a comma-separated list, in the order of the list.
/// @param option name of the option, for error messages
/// @throws InputError for an empty list
std::vector<std::string> parse_comma_separated_list(const std::string& option,
                                                    const std::string& list);

/// Returns the distinct integers of a comma-separated list, in the order of the list.
/// @throws InputError for an empty list or an item that is not an integer
std::vector<int> parse_integers(const std::string& option, const std::string& list);

/// Makes an option for each parameter in `description` that has a flag. Parsing replaces values in
/// `values` by the values on the command line.
/// @param values values of all parameters, in any order; the options keep a reference to `values`
/// @throws InputError during parsing, with the flag, the refused text and the allowed values
boost::program_options::options_description make_command_line_options(
    const base::DescriptionBase& description, base::Values& values);

/// Makes options without default values for the parameters in `names`. Parsing stores the options
/// that occur on the command line in `given`.
boost::program_options::options_description make_command_line_options(
    const base::DescriptionBase& description, const std::vector<std::string>& names,
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
