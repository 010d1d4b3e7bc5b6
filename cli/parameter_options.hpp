#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// The command-line options of described parameters: each that has a flag, with its help, its
/// default and its range from the description. What is given replaces the value in `values`.
/// @param values of all parameters, in any order; kept by reference
/// @throws InputError from parsing: the flag, the text and what is allowed
boost::program_options::options_description make_options(const base::DescriptionBase& description,
                                                         base::Values& values);

/// Those of the named parameters only, without defaults: `given` gets the ones that are given.
boost::program_options::options_description make_options(const base::DescriptionBase& description,
                                                         const std::vector<std::string>& names,
                                                         base::Values& given);

/// The options that the solvers let a command set which solves by many methods
/// (methods::Solver::run_options).
boost::program_options::options_description make_run_options(const methods::Registry& registry,
                                                             base::Values& given);

/// The value of --threads for methods that run in parallel; 0 without the option.
int thread_count(const base::Values& given);

}  // namespace fpkcheck::cli
