#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Makes the command-line options of the parameters that have a flag, with help, default and range
/// from the description. Parsing writes each given option to `values`.
/// @param values defaults of all parameters, in any order; kept by reference
/// @throws InputError while parsing: with the flag, its text and the allowed range
boost::program_options::options_description make_options(const base::DescriptionBase& description,
                                                         base::Values& values);

/// Makes the options of the named parameters only, without defaults. Parsing adds each given option
/// to `given`.
boost::program_options::options_description make_options(const base::DescriptionBase& description,
                                                         const std::vector<std::string>& names,
                                                         base::Values& given);

/// Makes the options of the commands that solve by several methods (methods::Solver::run_options).
boost::program_options::options_description make_run_options(const methods::Registry& registry,
                                                             base::Values& given);

/// The value of --threads for methods that run in parallel; 0 without the option.
int thread_count(const base::Values& given);

}  // namespace fpkcheck::cli
