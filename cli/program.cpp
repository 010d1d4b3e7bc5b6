#include "cli/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <boost/version.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/printable_text.hpp"
#include "cli/help.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "fd_fpk/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem_features.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"
#include "results/saved_run.hpp"

namespace fpkcheck::cli {
namespace {

std::string version_text() {
  auto libraries = fd_fpk::library_versions();
  for (auto& library : results::library_versions()) libraries.push_back(std::move(library));
  libraries.emplace_back("Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000,
                                              BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100));
  libraries.emplace_back("fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000,
                                            FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  const auto program = results::current_program("");
  std::string text = fmt::format("{} {}\n", program.name, program.version);
  for (const auto& [name, version] : libraries) text += fmt::format("  {:<14}{}\n", name, version);
  return text;
}

using Arguments = std::vector<std::string>;

struct Command {
  std::string name;
  std::string summary;
  std::function<int(const CommandInvocation&)> run;
};

Command make_solver_command(const methods::Solver& solver) {
  const auto run = solver.name == "fd"    ? fd_command
                   : solver.name == "mcs" ? mcs_command
                                          : solver_command;
  return {solver.name, solver.summary,
          [&solver, run](const CommandInvocation& call) { return run(call, solver); }};
}

std::vector<Command> all_commands(const methods::SolverRegistry& registry) {
  std::vector<Command> all{
      {"run", "solve cases by all methods and compare: tables, report.html, figures", run_command},
      {"paper", "test the claims of the paper and draw its figures", paper_command}};
  for (const auto& solver : registry.solvers()) all.push_back(make_solver_command(solver));
  const Command others[] = {
      {"bounds", "guaranteed bounds of moments, by the backward equation", bounds_command},
      {"passage", "first passage above a barrier: survival, mean times, hazard", passage_command},
      {"spectrum", "spectral density of y or y', by finite volumes and by simulation",
       spectrum_command},
      {"sensitivity", "derivatives of moments with respect to the parameters of a case",
       sensitivity_command},
      {"study", "convergence in order and grid, cost, growth of the truncated series",
       study_command},
      {"sweep", "solve a case for many parameter values: accuracy and cost of methods",
       sweep_command},
      {"advise", "recommend a method for a case and an accuracy, from solved problems",
       advise_command},
      {"reference", "reference values confirmed by two discretisations and a simulation",
       reference_command},
      {"check", "regression test: repeat a saved run and compare all its quantities",
       check_command},
      {"report", "rebuild table, report.html and figures of a saved run", report_command},
      {"evaluate", "evaluate p(y, y') of a closed form at points, from a run or a file",
       evaluate_command}};
  all.insert(all.end(), std::begin(others), std::end(others));
  return all;
}

std::string join_command_names(const std::vector<Command>& all) {
  std::vector<std::string> names;
  for (const auto& command : all) names.push_back(command.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void print_command_overview(const std::vector<Command>& all) {
  fmt::print(
      R"(fpkcheck - stationary densities of oscillators with or without impacts, under
           random impulses, white noise or both, by independent methods

    y'' + f(y, y') + g(y) = impulses + noise,    y'(+) = -r y'(-)  at walls

Oscillator of the paper:  y'' + c y' + k y + mu y^3 = impulses,  wall at y = 0.

usage: fpkcheck COMMAND [CASE ...] [options]

commands:
)");
  std::size_t column = 0;
  for (const auto& command : all) column = std::max(column, command.name.size() + 4);
  for (const auto& command : all) {
    auto lines = report::wrap_text(std::string(column, ' ') + command.summary, 80, column);
    fmt::print("{}", lines.replace(2, command.name.size(), command.name));
  }
  fmt::print(R"(
A CASE is case1 .. case4 (Table 1 of the paper), the name of another oscillator
(bistable, gap, van_der_pol, ..: docs/systems.md), or an ini file such as
cases/case1.ini. `fpkcheck COMMAND --help` and `fpkcheck help COMMAND` explain
the options of a command. Start with `fpkcheck run`.
Exit codes: 0 success; 1 a solver failed or did not reach the requested
accuracy, or a check failed; 2 bad input; 130 after Ctrl-C; 143 after SIGTERM.

)");
  std::vector<std::string_view> subjects;
  for (const auto& feature : problem::unsupported_features()) subjects.push_back(feature.subject);
  fmt::print("{}",
             report::wrap_text(fmt::format("Unsupported: {}.", fmt::join(subjects, "; ")), 80));
}

// Returns the help of all commands, where each subject of `study` counts as a command.
std::vector<CommandHelp> collect_command_help(const std::vector<Command>& all,
                                              const methods::SolverRegistry& registry) {
  std::vector<CommandHelp> result;
  const auto add = [&](const Command& command, const std::string& subject) {
    Arguments help_arguments{"--help"};
    if (!subject.empty()) help_arguments.insert(help_arguments.begin(), subject);
    const auto help = capture_help([&] { command.run({help_arguments, "", registry}); });
    result.push_back(subject.empty() ? CommandHelp{command.name, command.summary, help}
                                     : CommandHelp{command.name + ' ' + subject, "", help});
  };
  for (const auto& command : all) {
    add(command, "");
    if (command.name != "study") continue;
    for (const auto& subject : study_subjects()) add(command, subject.name);
  }
  return result;
}

int call_named_command(const Arguments& arguments, const methods::SolverRegistry& registry) {
  const auto all = all_commands(registry);
  if (arguments.empty()) {
    throw InputError(
        fmt::format("no command; use one of {} (--help explains them)", join_command_names(all)));
  }
  const std::string& name = arguments.front();
  if (name == "help" && arguments.size() > 1) {
    Arguments help_arguments{arguments.begin() + 1, arguments.end()};
    help_arguments.emplace_back("--help");
    return call_named_command(help_arguments, registry);
  }
  if (name == "--help" || name == "-h" || name == "help") {
    print_command_overview(all);
    return kSuccess;
  }
  if (name == "--version") {
    fmt::print("{}", version_text());
    return kSuccess;
  }
  // The undocumented options of the program are for the completion script and the build.
  if (name == "--complete") {
    const Arguments words{arguments.begin() + 1, arguments.end()};
    for (const auto& word :
         completion_candidates(collect_command_help(all, registry), registry, words)) {
      fmt::print("{}\n", word);
    }
    return kSuccess;
  }
  if (name == "--manual") {
    fmt::print("{}", manual_page(collect_command_help(all, registry)));
    return kSuccess;
  }
  const auto command = std::ranges::find(all, name, &Command::name);
  if (command == all.end()) {
    if (const std::string text = problem::unsupported_feature_message(name); !text.empty()) {
      throw InputError(fmt::format("{}: {}", base::in_quotes(name), text));
    }
    throw InputError(fmt::format("{} is not a command; use one of {} (--help explains them)",
                                 base::in_quotes(name), join_command_names(all)));
  }
  std::string command_line = "fpkcheck";
  for (const auto& argument : arguments) command_line += " " + argument;
  return command->run({{arguments.begin() + 1, arguments.end()}, command_line, registry});
}

}  // namespace

int run_program(const Arguments& arguments) {
  return run_program(arguments, methods::builtin_registry());
}

int run_program(const Arguments& arguments, const methods::SolverRegistry& registry) {
  const SignalHandlerGuard guard;
  set_exit_message("nothing was written");
  try {
    const int exit_code = call_named_command(arguments, registry);
    // The program detects a full disk or a closed pipe only when the output buffers are flushed.
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw std::runtime_error("standard output could not be written");
    }
    if (!base::stop_requested()) return exit_code;
  } catch (const InterruptedBySignal&) {
  } catch (const InputError& error) {
    print_message(error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    print_message(fmt::format("stopped: {}", methods::kOutOfMemory));
    return kFailure;
  } catch (const std::exception& error) {
    print_message(fmt::format("stopped: {}", error.what()));
    return kFailure;
  }
  claim_shutdown_for_this_thread();
  print_message(exit_message());
  return signal_exit_code(base::requested_stop_signal());
}

}  // namespace fpkcheck::cli
