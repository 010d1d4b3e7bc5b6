#pragma once

#include <string>

#include "cli/command_line.hpp"
#include "fd_fpk/transient.hpp"

namespace fpkcheck::cli {

/// Integrates the density of one case over time, prints the table (or the JSON), and with --out
/// writes transient.nc and its figure. The directory is prepared before the integration.
/// @return an ExitCode
/// @throws InputError as load_cases, prepare_output_directory and fd_fpk::validate do, and for several cases
int integrate_and_report(const CommonArguments& common, const fd_fpk::Options& options,
                         fd_fpk::TransientOptions transient, const std::string& command_line);

}  // namespace fpkcheck::cli
