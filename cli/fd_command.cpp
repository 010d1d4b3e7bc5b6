#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/figure_options.hpp"
#include "cli/integrate_and_report.hpp"
#include "cli/parameter_options.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/transient_options.hpp"

namespace fpkcheck::cli {
namespace {

using base::Values;
using fd_fpk::TransientOptions;

/// Names of the options of a density over time: --until, --snapshots and others.
std::vector<std::string> transient_option_names() {
  std::vector<std::string> names;
  for (const auto& parameter : fd_fpk::transient_option_descriptions().parameters()) {
    if (!parameter.flag.empty()) names.push_back(parameter.name);
  }
  return names;
}

TransientOptions transient_options(const Values& given) {
  if (!contains(given, "until")) {
    throw InputError(
        "--snapshots, --time-tolerance or --start-.. without --until: no density over time was "
        "requested; give --until T");
  }
  TransientOptions options;
  for (const auto& [name, value] : given) {
    const auto& description = fd_fpk::transient_option_descriptions();
    description.assign(options, *description.find(name), value, "--" + name);
  }
  return options;
}

}  // namespace

int fd_command(const CommandCall& call, const methods::Solver& solver) {
  CommonArguments common;
  Values values = solver.default_options, transient_values;
  auto own = make_command_line_options(*solver.option_descriptions, values);
  own.add(make_command_line_options(fd_fpk::transient_option_descriptions(),
                                    transient_option_names(), transient_values));
  own.add(make_case_figure_options(common.figures));
  if (!parse_arguments(call.arguments, solver.usage, add_common_options(own, common),
                       common.cases)) {
    return kSuccess;
  }
  if (transient_values.empty()) {
    return solve_and_report(common, {call.registry.make_method(solver, values)}, {},
                            call.command_line);
  }
  const auto options = fd_fpk::description().read(values, "options");
  if (options.stepper == fd_fpk::StationarySolver::direct) {
    throw InputError(
        "--stepper direct with --until: a density over time requires time steps; omit --stepper");
  }
  return integrate_and_report(common, options, transient_options(transient_values),
                              call.command_line);
}

}  // namespace fpkcheck::cli
