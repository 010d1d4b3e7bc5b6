#include "cli/solve_and_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <mutex>
#include <optional>

#include "base/process/stop_request.hpp"
#include "base/process/stopwatch.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "methods/case_results.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/write_report.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::cli {
namespace {

bool must_be_ok(const transform::Solution& solution, const SolveAndReportOptions& options) {
  const auto& identity = solution.identity;
  if (transform::is_external(identity)) return false;  // no solver computed this density
  if (solution.status == transform::Status::not_offered) {
    return options.required == SolutionsRequiredForSuccess::all &&
           (options.requested_ids.empty() ||
            std::ranges::count(options.requested_ids, identity.id) > 0);
  }
  if (options.required == SolutionsRequiredForSuccess::all) return true;
  return identity.role != transform::SolutionRole::closure &&
         identity.impact != problem::ImpactCondition::delta;
}

std::vector<std::string> failure_messages(const results::Run& run,
                                          const SolveAndReportOptions& options) {
  std::vector<std::string> lines;
  for (const auto& case_result : run.cases) {
    if (case_result.bounds) {
      for (const auto& outside :
           compare::violations_beyond_error_estimate(*case_result.bounds, case_result.solutions)) {
        lines.push_back(fmt::format("{}: {} contradicts the guaranteed bounds of {}",
                                    case_result.name(), outside.solution->id(),
                                    outside.bound->functional));
      }
    }
    for (const auto& solution : case_result.solutions) {
      if (solution.has_status_ok() || !must_be_ok(solution, options)) continue;
      lines.push_back(fmt::format("{}: {} {}: {}", case_result.name(), solution.id(),
                                  name(solution.status), solution.reason));
    }
  }
  return lines;
}

// Thread-safe collection of the completed cases of a run, for a report after a stop signal.
class FinishedCaseResults {
 public:
  void store_case(const results::CaseResult& case_result) {
    const std::lock_guard lock(mutex_);
    const auto before = std::ranges::find(cases_, case_result.name(), &results::CaseResult::name);
    if (before == cases_.end()) {
      cases_.push_back(case_result);
    } else {
      *before = case_result;
    }
  }

  std::vector<results::CaseResult> cases_in_order(
      const std::vector<problem::Problem>& problems) const {
    const std::lock_guard lock(mutex_);
    std::vector<results::CaseResult> ordered;
    for (const auto& problem : problems) {
      const auto found = std::ranges::find(cases_, problem.name, &results::CaseResult::name);
      if (found != cases_.end()) ordered.push_back(*found);
    }
    return ordered;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<results::CaseResult> cases_;
};

// Returns a text on the cause of a stop of the program and on the results that are missing after
// the stop.
std::string interruption_text(const std::vector<results::CaseResult>& cases,
                              const std::vector<problem::Problem>& problems, bool with_backward) {
  std::vector<std::string> missing, unbounded;
  for (const auto& problem : problems) {
    const auto found = std::ranges::find(cases, problem.name, &results::CaseResult::name);
    if (found == cases.end()) {
      missing.push_back(problem.name);
    } else if (with_backward && !found->bounds) {
      unbounded.push_back(problem.name);
    }
  }
  std::string text =
      fmt::format("This run was stopped by {} before its end.",
                  base::requested_stop_signal() == SIGTERM ? "SIGTERM" : "Ctrl-C (SIGINT)");
  if (!missing.empty()) text += fmt::format(" Missing: {}.", fmt::join(missing, ", "));
  if (!unbounded.empty()) {
    text += fmt::format(" Without bounds and error estimates: {}.", fmt::join(unbounded, ", "));
  }
  return text;
}

// The partial report after a stop signal has no figures, since figures would take too long.
void write_partial_report(const std::filesystem::path& directory, const results::Run& run) {
  const base::ProcessExitBlocker in_hand;
  report::write_report(directory, run);
  set_exit_message(fmt::format("{} case{} written to {} (`fpkcheck report {}` draws the figures)",
                               run.cases.size(), run.cases.size() == 1 ? " was" : "s were",
                               directory.string(), directory.string()));
}

}  // namespace

int solve_and_report(const CommonCommandArguments& common,
                     const std::vector<methods::Method>& methods,
                     const SolveAndReportOptions& options, const std::string& command_line) {
  const base::Stopwatch stopwatch;
  const auto problems = load_cases(common);
  std::vector<transform::SolutionIdentity> identities;
  for (const auto& method : methods) identities.push_back(method.identity);
  report::require_requested_curves_exist(common.figures.curves, identities);
  const OutputDirectory directory(common.out);

  ProgressLine progress(common.quiet);
  results::Run run{results::current_program(command_line), {}};
  FinishedCaseResults finished;
  std::atomic<bool> solved = false;
  const auto stopped_run = [&] {
    results::Run stopped{results::current_program(command_line), finished.cases_in_order(problems)};
    if (!solved)
      stopped.stopped = interruption_text(stopped.cases, problems, options.with_backward);
    return stopped;
  };
  std::optional<ShutdownHook> hook;
  if (common.out) {
    hook.emplace([&] {
      const results::Run stopped = stopped_run();
      if (!stopped.cases.empty()) write_partial_report(*common.out, stopped);
    });
  }
  try {
    run.cases = methods::compute_case_results(
        problems, methods,
        {.threads = options.threads,
         .with_backward = options.with_backward,
         .progress =
             [&](const methods::RunProgress& at) {
               // A running method with the completed fraction 0 has no partial result that could be
               // kept.
               set_interruption_policy(at.fraction > 0 ? options.interruption_policy
                                                       : InterruptionPolicy::abort);
               progress.show_progress(at);
             },
         .case_listener =
             [&](const results::CaseResult& case_result) { finished.store_case(case_result); },
         .poll = throw_if_interrupted});
    solved = !base::stop_requested();
  } catch (const InterruptedBySignal&) {
  }
  progress.erase_line();
  const bool stopped = !solved;
  if (stopped) {
    run = stopped_run();
    if (run.cases.empty()) throw InterruptedBySignal();
    if (common.out) {
      write_partial_report(*common.out, run);
    } else {
      set_exit_message(fmt::format("{} of {} cases {} reached", run.cases.size(), problems.size(),
                                   run.cases.size() == 1 ? "was" : "were"));
    }
  }

  const RunSupplement supplement =
      options.supplement && !stopped ? options.supplement(run) : RunSupplement{};
  if (common.json) {
    print_output((supplement.json.empty() ? results::run_summary_text(run) : supplement.json) +
                 '\n');
  } else if (!common.quiet) {
    print_output(report::terminal_report_text(run, supplement.report, terminal_format()));
  }
  if (stopped) return kFailure;  // the caller sets the exit code of the signal

  bool all_drawn = true;
  if (common.out) {
    const base::ProcessExitBlocker in_hand;
    for (const auto& warning :
         report::write_report(*common.out, run, common.figures, supplement.report)) {
      print_message(warning);
      all_drawn = false;
    }
    set_exit_message(fmt::format(
        "all files except figures were written to {0} (`fpkcheck report {0}` draws the figures)",
        *common.out));
  }
  hook.reset();
  if (base::stop_requested()) return kFailure;
  if (!common.quiet && !common.json) {
    const auto any = [&](auto results::CaseResult::*list) {
      return std::ranges::any_of(run.cases, [&](const results::CaseResult& case_result) {
        return !(case_result.*list).empty();
      });
    };
    std::string others;
    for (const auto& file : supplement.report.files) others += ", " + file.name;
    print_output(fmt::format(
        "\n{}{:.1f} s.\n",
        common.out
            ? fmt::format("Wrote report.html, summary.json, marginals.csv{}{}{} and {} to {} in ",
                          any(&results::CaseResult::smooth) ? ", smooth.csv" : "",
                          any(&results::CaseResult::joints) ? ", joint.nc" : "", others,
                          all_drawn ? "figures/" : "some figures", *common.out)
            : "Done in ",
        stopwatch.seconds()));
  }
  auto failed = failure_messages(run, options);
  failed.insert(failed.end(), supplement.failures.begin(), supplement.failures.end());
  if (common.quiet) {
    for (const auto& line : failed) print_message(line);
  }
  return failed.empty() ? kSuccess : kFailure;
}

}  // namespace fpkcheck::cli
