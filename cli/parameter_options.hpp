#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Command-line options of all described parameters that have a flag. Help text, default and range
/// of each option are those of the description. An option on the command line replaces the value of
/// the parameter in `values`.
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

}  // namespace fpkcheck::cli
