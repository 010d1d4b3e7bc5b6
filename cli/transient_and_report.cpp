#include "cli/transient_and_report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "parameters/input_error.hpp"
#include "parameters/shown.hpp"
#include "results/directory.hpp"
#include "study/transient/report.hpp"

namespace fpkcheck::cli {

int transient_and_report(const CommonArguments& common, const fd_fpk::Options& options,
                         fd_fpk::TransientOptions transient, const std::string& command_line) {
  fd_fpk::validate(options, transient);
  const auto problems = load_cases(common);
  if (problems.size() > 1) {
    throw InputError(
        fmt::format("--until with {} cases (a density over time is of one case)", problems.size()));
  }
  results::MadeDirectories made;
  if (common.out) made = results::make_writable(*common.out);

  const auto& problem = problems.front();
  const InterruptionGuard guard;
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
    fmt::print("{}\n", study::transient_json(run));
  } else if (!common.quiet) {
    fmt::print("{}", study::transient_table(run, terminal_format().width));
    std::fflush(stdout);
  }
  if (common.out) {
    for (const auto& warning : study::write_transient(*common.out, run)) {
      fmt::print(stderr, "fpkcheck: {}\n", parameters::one_line(warning));
    }
  }
  if (!common.quiet && !common.json) {
    fmt::print(
        "\n{}{:.1f} s.\n",
        common.out && !run.result.snapshots.empty()
            ? fmt::format("Wrote transient.nc and figures/ to {}; integrated in ", *common.out)
            : "Done in ",
        run.result.seconds);
  }
  return run.result.status == transform::Status::ok ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
