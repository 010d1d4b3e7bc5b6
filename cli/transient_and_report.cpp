#include "cli/transient_and_report.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"
#include "base/process/write_guard.hpp"
#include "cli/ending.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "workflows/study/transient/report.hpp"

namespace fpkcheck::cli {

int transient_and_report(const CommonArguments& common, const fd_fpk::Options& options,
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
    progress.show({.done = 0,
                   .total = 1,
                   .case_name = problem.name,
                   .method = "over time",
                   .fraction = fraction});
  };
  auto result = fd_fpk::integrate(problem, options, transient);
  throw_if_interrupted();
  progress.clear();

  const study::TransientRun run{command_line, problem, options, transient, std::move(result)};
  if (common.json) {
    put_out(study::transient_json(run) + '\n');
  } else if (!common.quiet) {
    put_out(study::transient_table(run, terminal_format().width));
  }
  if (common.out) {
    const base::WriteGuard in_hand;
    for (const auto& warning : study::write_transient(*common.out, run, common.figures))
      complain(warning);
    note_kept("all files were written except the figure");
  }
  if (!common.quiet && !common.json) {
    put_out(fmt::format(
        "\n{}{:.1f} s.\n",
        common.out && !run.result.snapshots.empty()
            ? fmt::format("Wrote transient.nc and figures/ to {}; integrated in ", *common.out)
            : "Done in ",
        run.result.seconds));
  }
  if (common.quiet && run.result.status != transform::Status::ok) {
    complain(fmt::format("{}: over time {}: {}", problem.name, name(run.result.status),
                         run.result.reason));
  }
  return run.result.status == transform::Status::ok ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
