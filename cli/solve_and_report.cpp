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
#include "methods/bounds.hpp"
#include "methods/own_errors.hpp"
#include "methods/run_cases.hpp"
#include "parameters/shown.hpp"
#include "report/report.hpp"
#include "report/table.hpp"
#include "results/directory.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::cli {
namespace {

bool is_required(const transform::Identity& identity, Required required) {
  if (required == Required::all) return true;
  return identity.role != transform::Role::closure && identity.impact != problem::Impact::delta;
}

bool reached(const results::Run& run, Required required) {
  return std::ranges::all_of(run.cases, [&](const results::Case& one) {
    if (one.bounds && !compare::contradictions(*one.bounds, one.solutions).empty()) return false;
    return std::ranges::all_of(one.solutions, [&](const transform::Solution& solution) {
      return solution.is_ok() || !is_required(solution.identity, required);
    });
  });
}

}  // namespace

report::TextFormat terminal_format() {
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

int solve_and_report(const CommonArguments& common, const std::vector<methods::Method>& methods,
                     const SolveControl& control, const std::string& command_line) {
  const auto begin = std::chrono::steady_clock::now();
  const auto problems = load_cases(common);
  results::MadeDirectories made;
  if (common.out) made = results::make_writable(*common.out);

  const InterruptionGuard guard(control.on_interruption);
  ProgressLine progress(common.quiet);
  const auto residuals = methods::residuals_of(problems);
  results::Run run{results::this_program(command_line),
                   methods::run_cases(
                       problems, methods, control.threads,
                       [&](const methods::RunProgress& at) { progress.show(at); }, residuals)};
  throw_if_interrupted();
  if (control.with_dual) {
    methods::add_bounds(run.cases, control.threads);
    methods::add_own_errors(run.cases, residuals, control.threads);
  }
  throw_if_interrupted();
  progress.clear();

  if (common.json) {
    fmt::print("{}\n", results::summary_text(run));
  } else if (!common.quiet) {
    fmt::print("{}", report::table(run, terminal_format()));
    std::fflush(stdout);
  }
  bool all_drawn = true;
  if (common.out) {
    for (const auto& warning : report::write_report(*common.out, run)) {
      fmt::print(stderr, "fpkcheck: {}\n", parameters::one_line(warning));
      all_drawn = false;
    }
  }
  if (!common.quiet && !common.json) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    const auto any = [&](auto results::Case::*list) {
      return std::ranges::any_of(run.cases,
                                 [&](const results::Case& one) { return !(one.*list).empty(); });
    };
    fmt::print(
        "\n{}{:.1f} s.\n",
        common.out
            ? fmt::format("Wrote report.html, summary.json, marginals.csv{}{} and {} to {} in ",
                          any(&results::Case::smooth) ? ", smooth.csv" : "",
                          any(&results::Case::joints) ? ", joint.nc" : "",
                          all_drawn ? "figures/" : "what could be drawn", *common.out)
            : "Done in ",
        elapsed.count());
  }
  return reached(run, control.required) ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
