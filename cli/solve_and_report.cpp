#include "cli/solve_and_report.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "compare/report.hpp"
#include "compare/run_cases.hpp"
#include "compare/run_directory.hpp"
#include "compare/table.hpp"

namespace fpkcheck::cli {
namespace {

bool reached(const std::vector<compare::CaseReport>& cases, Required required) {
  return std::ranges::all_of(cases, [&](const compare::CaseReport& report) {
    return std::ranges::all_of(report.entries, [&](const compare::Entry& entry) {
      const bool reference =
          entry.solution.method != "epc" && entry.solution.impact != problem::Impact::delta;
      const bool needed = required == Required::all || reference;
      return !needed || entry.solution.status == transform::Status::ok;
    });
  });
}

}  // namespace

compare::TextFormat terminal_format() {
  constexpr std::size_t kNarrowest = 80, kWidest = 100;
  const auto is = [](const char* variable, auto condition) {
    const char* const value = std::getenv(variable);
    return value != nullptr && condition(std::string_view(value));
  };
  const bool plain = is("NO_COLOR", [](auto value) { return !value.empty(); }) ||
                     is("TERM", [](auto value) { return value == "dumb"; });
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return {known ? std::clamp<std::size_t>(size.ws_col, kNarrowest, kWidest) : kWidest,
          isatty(STDOUT_FILENO) == 1 && !plain};
}

int solve_and_report(const CommonArguments& common, const std::vector<compare::Method>& methods,
                     int threads, Required required, const std::string& command_line) {
  const auto begin = std::chrono::steady_clock::now();
  const auto problems = load_cases(common);
  compare::MadeDirectories made;
  if (common.out) made = compare::make_writable(*common.out);

  const InterruptionGuard guard;
  ProgressLine progress(common.quiet);
  const auto cases = compare::run_cases(problems, methods, threads,
                                        [&](const compare::RunProgress& at) { progress.show(at); });
  throw_if_interrupted();
  progress.clear();

  const auto run = compare::make_run(command_line, cases);
  if (common.json) {
    fmt::print("{}\n", compare::json_text(run.summary));
  } else if (!common.quiet) {
    fmt::print("{}", compare::table(run.summary, terminal_format()));
    std::fflush(stdout);
  }
  bool all_drawn = true;
  if (common.out) {
    for (const auto& warning : compare::write_report(*common.out, run)) {
      fmt::print(stderr, "fpkcheck: {}\n", warning);
      all_drawn = false;
    }
  }
  if (!common.quiet && !common.json) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    fmt::print("\n{}{:.1f} s.\n",
               common.out ? fmt::format(
                                "Wrote report.html, summary.json, marginals.csv{} and {} to {} in ",
                                run.joints.empty() ? "" : ", joint.nc",
                                all_drawn ? "figures/" : "what could be drawn", *common.out)
                          : "Done in ",
               elapsed.count());
  }
  return reached(cases, required) ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
