#pragma once

#include <string>

#include "cli/command_line.hpp"
#include "fd_fpk/transient.hpp"

namespace fpkcheck::cli {

/// Integrates the density of one case over time, prints the table (or the JSON), and with --out
/// writes transient.nc and its figure. The output directory is prepared before the integration.
/// @return an ExitCode
/// @throws InputError if load_cases, prepare_output_directory or fd_fpk::validate throws
/// InputError, and for more than one case
int integrate_and_report(const CommonArguments& common, const fd_fpk::Options& options,
                         fd_fpk::TransientOptions transient, const std::string& command_line);

}  // namespace fpkcheck::cli
