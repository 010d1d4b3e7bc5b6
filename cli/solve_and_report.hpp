#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "compare/methods.hpp"

namespace fpkcheck::cli {

/// Which solutions must be `ok` for the exit code 0.
enum class Required {
  all,        ///< each was asked for by name
  references  ///< finite differences and simulation: how far the closures carry is the question
};

/// Solves the cases by the methods, prints the table (or the JSON), and writes the report when a
/// directory was given. The directory is prepared before anything is solved.
/// @return an ExitCode
int solve_and_report(const CommonArguments& common, const std::vector<compare::Method>& methods,
                     int threads, Required required, const std::string& command_line);

/// Width of the terminal within 80 .. 100 characters; 100 when standard output is none.
std::size_t table_width();

}  // namespace fpkcheck::cli
