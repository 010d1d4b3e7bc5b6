#include <fmt/format.h>

#include <string>

#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/terminal.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/transient.hpp"
#include "workflows/study/transient/report_over_time.hpp"

namespace fpkcheck::cli {
namespace {

using base::Values;
using fd_fpk::TransientOptions;

TransientOptions transient_options(const Values& given) {
  if (!contains(given, "until")) {
    throw InputError(
        "--snapshots, --time-tolerance, --periodic or --start-.. without --until: no density over "
        "time was requested; give --until T");
  }
  TransientOptions options;
  for (const auto& [name, value] : given) {
    const auto& description = fd_fpk::transient_option_descriptions();
    description.assign_option_value(options, *description.find(name), value, "--" + name);
  }
  return options;
}

// Integrates the density of one case over time, and prints a table or JSON. With the option --out
// the results are written to transient.nc and a figure.
// @throws InputError for invalid cases or options, and for more than one case
int integrate_and_report(CommonCommandArguments common, const fd_fpk::FiniteVolumeOptions& options,
                         fd_fpk::TransientOptions transient, const std::string& command_line) {
  fd_fpk::validate(options, transient);
  common.time_section = problem::CaseFileTimeSectionPolicy::allowed;
  const auto problems = load_cases(common);
  if (problems.size() > 1) {
    throw InputError(fmt::format(
        "--until with {} cases: a density over time requires one case; name one", problems.size()));
  }
  const OutputDirectory directory(common.out);

  const auto& problem = problems.front();
  ProgressLine progress(common.quiet);
  transient.progress = [&](double fraction) {
    progress.show_progress({.done = 0,
                            .total = 1,
                            .case_name = problem.name,
                            .method = "over time",
                            .fraction = fraction});
  };
  auto result = fd_fpk::solve_transient(problem, options, transient);
  throw_if_interrupted();
  progress.erase_line();

  const study::TransientRun run{command_line, problem, options, transient, std::move(result)};
  if (common.json) {
    print_output(study::transient_json(run) + '\n');
  } else if (!common.quiet) {
    print_output(study::transient_table(run, terminal_format().width));
  }
  if (common.out) {
    const base::ProcessExitBlocker in_hand;
    for (const auto& warning : study::write_transient_files(*common.out, run, common.figures))
      print_message(warning);
    set_exit_message("all files were written except the figure");
  }
  if (!common.quiet && !common.json) {
    print_output(fmt::format(
        "\n{}{:.1f} s.\n",
        common.out && !run.result.snapshots.empty()
            ? fmt::format("Wrote transient.nc and figures/ to {}; integrated in ", *common.out)
            : "Done in ",
        run.result.seconds));
  }
  if (common.quiet && run.result.status != transform::Status::ok) {
    print_message(fmt::format("{}: over time {}: {}", problem.name, name(run.result.status),
                              run.result.reason));
  }
  return run.result.status == transform::Status::ok ? kSuccess : kFailure;
}

}  // namespace

int fd_command(const CommandInvocation& call, const methods::Solver& solver) {
  CommonCommandArguments common;
  Values values = solver.default_options, transient_values;
  auto own = make_command_line_options(*solver.option_descriptions, values);
  own.add(make_command_line_options(fd_fpk::transient_option_descriptions(), transient_values));
  own.add(make_case_figure_options(common.figures));
  if (!parse_case_arguments(call.arguments, solver.usage, own, common)) return kSuccess;
  if (transient_values.empty()) {
    return solve_and_report(common, {call.registry.make_method(solver, values)}, {},
                            call.command_line);
  }
  const auto options = fd_fpk::solver_option_descriptions().read(values, "options");
  if (options.stepper == fd_fpk::StationarySolver::direct) {
    throw InputError(
        "--stepper direct with --until: a density over time requires time steps; omit --stepper");
  }
  return integrate_and_report(common, options, transient_options(transient_values),
                              call.command_line);
}

}  // namespace fpkcheck::cli
