#include "cli/integrate_and_report.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"
#include "base/process/exit_blocker.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/shutdown.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "workflows/study/transient/report.hpp"

namespace fpkcheck::cli {

int integrate_and_report(const CommonArguments& common, const fd_fpk::Options& options,
                         fd_fpk::TransientOptions transient, const std::string& command_line) {
  fd_fpk::validate(options, transient);
  const auto problems = load_cases(common);
  if (problems.size() > 1) {
    throw InputError(fmt::format(
        "--until with {} cases: a density over time requires one case; name one", problems.size()));
  }
  const OutputDirectory directory(common.out);

  const auto& problem = problems.front();
  ProgressLine progress(common.quiet);
  transient.progress = [&](double fraction) {
    progress.rewrite({.done = 0,
                      .total = 1,
                      .case_name = problem.name,
                      .method = "over time",
                      .fraction = fraction});
  };
  auto result = fd_fpk::solve_transient(problem, options, transient);
  throw_if_interrupted();
  progress.erase();

  const study::TransientRun run{command_line, problem, options, transient, std::move(result)};
  if (common.json) {
    print_output(study::transient_json(run) + '\n');
  } else if (!common.quiet) {
    print_output(study::transient_table(run, terminal_format().width));
  }
  if (common.out) {
    const base::ExitBlocker in_hand;
    for (const auto& warning : study::write_transient(*common.out, run, common.figures))
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

}  // namespace fpkcheck::cli
