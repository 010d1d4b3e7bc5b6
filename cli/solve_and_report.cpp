#include "cli/solve_and_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string_view>

#include "base/process/stop.hpp"
#include "base/process/write_guard.hpp"
#include "cli/ending.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/standard_streams.hpp"
#include "methods/complete_run.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/report.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::cli {
namespace {

bool is_required(const transform::Solution& solution, const SolveControl& control) {
  const auto& identity = solution.identity;
  if (transform::is_external(identity)) return false;  // nothing was asked of a solver
  if (solution.status == transform::Status::not_offered) {
    return control.required == Required::all &&
           (control.named.empty() || std::ranges::count(control.named, identity.id) > 0);
  }
  if (control.required == Required::all) return true;
  return identity.role != transform::Role::closure && identity.impact != problem::Impact::delta;
}

// The reasons for an exit code other than 0, a line each.
std::vector<std::string> failures(const results::Run& run, const SolveControl& control) {
  std::vector<std::string> lines;
  for (const auto& one : run.cases) {
    if (one.bounds) {
      for (const auto& outside : compare::contradictions(*one.bounds, one.solutions)) {
        lines.push_back(fmt::format("{}: {} contradicts the guaranteed bounds of {}", one.name(),
                                    outside.solution->id(), outside.bound->functional));
      }
    }
    for (const auto& solution : one.solutions) {
      if (solution.is_ok() || !is_required(solution, control)) continue;
      lines.push_back(fmt::format("{}: {} {}: {}", one.name(), solution.id(), name(solution.status),
                                  solution.reason));
    }
  }
  return lines;
}

// The completed cases of a run, for a report after a stop signal. Thread-safe.
class FinishedCases {
 public:
  /// Adds a case, or replaces the case of the same name.
  void put(const results::Case& one) {
    const std::lock_guard lock(mutex_);
    const auto before = std::ranges::find(cases_, one.name(), &results::Case::name);
    if (before == cases_.end()) {
      cases_.push_back(one);
    } else {
      *before = one;
    }
  }

  /// The completed cases, in the order of the problems.
  std::vector<results::Case> in_order(const std::vector<problem::Problem>& problems) const {
    const std::lock_guard lock(mutex_);
    std::vector<results::Case> ordered;
    for (const auto& problem : problems) {
      const auto found = std::ranges::find(cases_, problem.name, &results::Case::name);
      if (found != cases_.end()) ordered.push_back(*found);
    }
    return ordered;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<results::Case> cases_;
};

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

// The text of results::Run::stopped.
std::string stopped_text(const std::vector<results::Case>& cases,
                         const std::vector<problem::Problem>& problems, bool with_backward) {
  std::vector<std::string> missing, unbounded;
  for (const auto& problem : problems) {
    const auto found = std::ranges::find(cases, problem.name, &results::Case::name);
    if (found == cases.end()) {
      missing.push_back(problem.name);
    } else if (with_backward && !found->bounds) {
      unbounded.push_back(problem.name);
    }
  }
  std::string text = fmt::format("This run was stopped by {} before its end.",
                                 base::stop_signal() == SIGTERM ? "SIGTERM" : "Ctrl-C (SIGINT)");
  if (!missing.empty()) text += fmt::format(" Missing: {}.", joined(missing));
  if (!unbounded.empty()) {
    text += fmt::format(" Without bounds and error estimates: {}.", joined(unbounded));
  }
  return text;
}

// Writes the completed cases after a stop signal. Figures would take too long.
void write_stopped(const std::filesystem::path& directory, const results::Run& run) {
  const base::WriteGuard in_hand;
  report::write_report(directory, run);
  note_kept(fmt::format("{} case{} written to {} (`fpkcheck report {}` draws the figures)",
                        run.cases.size(), run.cases.size() == 1 ? " was" : "s were",
                        directory.string(), directory.string()));
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
  std::vector<transform::Identity> identities;
  for (const auto& method : methods) identities.push_back(method.identity);
  report::validate_curves(common.figures.curves, identities);
  const OutputDirectory directory(common.out);

  ProgressLine progress(common.quiet);
  results::Run run{results::this_program(command_line), {}};
  FinishedCases finished;
  std::atomic<bool> solved = false;
  const auto stopped_run = [&] {
    results::Run stopped{results::this_program(command_line), finished.in_order(problems)};
    if (!solved) stopped.stopped = stopped_text(stopped.cases, problems, control.with_backward);
    return stopped;
  };
  std::optional<Rescue> rescue;
  if (common.out) {
    rescue.emplace([&] {
      const results::Run stopped = stopped_run();
      if (!stopped.cases.empty()) write_stopped(*common.out, stopped);
    });
  }
  try {
    run.cases = methods::complete_run(
        problems, methods,
        {.threads = control.threads,
         .with_backward = control.with_backward,
         .progress =
             [&](const methods::RunProgress& at) {
               // At the fraction 0 a method has no partial result to finish with.
               on_interruption(at.fraction > 0 ? control.on_interruption : OnInterruption::give_up);
               progress.show(at);
             },
         .case_listener = [&](const results::Case& one) { finished.put(one); },
         .poll = throw_if_interrupted});
    solved = !base::stop_requested();
  } catch (const Interrupted&) {
  }
  progress.clear();
  const bool stopped = !solved;
  if (stopped) {
    run = stopped_run();
    if (run.cases.empty()) throw Interrupted();
    if (common.out) {
      write_stopped(*common.out, run);
    } else {
      note_kept(fmt::format("{} of {} cases {} reached", run.cases.size(), problems.size(),
                            run.cases.size() == 1 ? "was" : "were"));
    }
  }

  const Supplement supplement =
      control.supplement && !stopped ? control.supplement(run) : Supplement{};
  if (common.json) {
    put_out((supplement.json.empty() ? results::summary_text(run) : supplement.json) + '\n');
  } else if (!common.quiet) {
    put_out(report::terminal_text(run, supplement.report, terminal_format()));
  }
  if (stopped) return kNotReached;  // the caller sets the exit code of the signal

  bool all_drawn = true;
  if (common.out) {
    const base::WriteGuard in_hand;
    for (const auto& warning :
         report::write_report(*common.out, run, common.figures, supplement.report)) {
      complain(warning);
      all_drawn = false;
    }
    note_kept(fmt::format("all but figures was written to {0} (`fpkcheck report {0}` draws them)",
                          *common.out));
  }
  rescue.reset();
  if (base::stop_requested()) return kNotReached;
  if (!common.quiet && !common.json) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    const auto any = [&](auto results::Case::*list) {
      return std::ranges::any_of(run.cases,
                                 [&](const results::Case& one) { return !(one.*list).empty(); });
    };
    std::string others;
    for (const auto& file : supplement.report.files) others += ", " + file.name;
    put_out(fmt::format(
        "\n{}{:.1f} s.\n",
        common.out
            ? fmt::format("Wrote report.html, summary.json, marginals.csv{}{}{} and {} to {} in ",
                          any(&results::Case::smooth) ? ", smooth.csv" : "",
                          any(&results::Case::joints) ? ", joint.nc" : "", others,
                          all_drawn ? "figures/" : "some figures", *common.out)
            : "Done in ",
        elapsed.count()));
  }
  auto failed = failures(run, control);
  failed.insert(failed.end(), supplement.failures.begin(), supplement.failures.end());
  if (common.quiet) {
    for (const auto& line : failed) complain(line);
  }
  return failed.empty() ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
