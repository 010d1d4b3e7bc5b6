#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::cli {

/// What every command that solves something takes.
struct CommonArguments {
  std::vector<std::string> cases;
  std::vector<std::string> overrides;  ///< --set key=value
  std::optional<std::string> out;
  bool quiet = false;
  bool json = false;
  report::FigureOptions figures = {};  ///< of commands that draw (cli/figure_options.hpp)
};

/// Adds --set, --out, --quiet, --json and --help to a command's own options.
/// @param what_out_does help text of --out
boost::program_options::options_description with_common_options(
    const boost::program_options::options_description& own, CommonArguments& common,
    const char* what_out_does =
        "write summary.json, marginals.csv, smooth.csv, joint.nc and figures/ there (run: default "
        "fpkcheck-out)");

/// The same without --set, for cases that are what they are.
boost::program_options::options_description with_output_options(
    const boost::program_options::options_description& own, CommonArguments& common,
    const char* what_out_does);

/// Parses, with the positional arguments going to `positional`. Options are not guessed from
/// prefixes.
/// @param usage first lines of the help text
/// @return false when --help was given and has been printed
/// @throws InputError on one line
bool parse(const std::vector<std::string>& arguments, const std::string& usage,
           const boost::program_options::options_description& options,
           std::vector<std::string>& positional);

/// The problems that the cases name, with the overrides applied.
/// @throws InputError, also when two cases have the same name
std::vector<problem::Problem> load_cases(const CommonArguments& common);

}  // namespace fpkcheck::cli
