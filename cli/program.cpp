#include "cli/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>

#include "base/input_error.hpp"
#include "base/process/stop.hpp"
#include "base/text/sanitise.hpp"
#include "cli/commands.hpp"
#include "cli/completion.hpp"
#include "cli/ending.hpp"
#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "cli/manual.hpp"
#include "cli/standard_streams.hpp"
#include "cli/studies.hpp"
#include "cli/version.hpp"
#include "methods/builtin.hpp"
#include "methods/out_of_memory.hpp"
#include "problem/unsupported_features.hpp"
#include "report/text/wrap_text.hpp"
#include "results/run.hpp"

namespace fpkcheck::cli {
namespace {

using Arguments = std::vector<std::string>;

struct Command {
  std::string name;
  std::string summary;
  std::function<int(const Call&)> run;
};

// A solver's command is its own where it can do more than solve.
Command command_of(const methods::Solver& solver) {
  const auto run = solver.name == "fd"    ? fd_command
                   : solver.name == "mcs" ? mcs_command
                                          : solver_command;
  return {solver.name, solver.summary,
          [&solver, run](const Call& call) { return run(call, solver); }};
}

std::vector<Command> commands(const methods::Registry& registry) {
  std::vector<Command> all{
      {"run", "all methods on all cases, compared: tables, report.html, pictures", run_command}};
  all.push_back({"paper", "the paper's claims one by one, and its figures", paper_command});
  for (const auto& solver : registry.solvers()) all.push_back(command_of(solver));
  all.push_back(
      {"bounds", "guaranteed bounds of moments, by the backward equation", bounds_command});
  all.push_back({"study", "what order, step and regularisation do: convergence, cost, growth",
                 study_command});
  all.push_back({"sweep", "many points of a case whose keys are varied: where which method holds",
                 sweep_command});
  all.push_back({"advise", "which method for a case: what kept an accuracy at problems like it",
                 advise_command});
  all.push_back({"reference", "reference values, agreed on by two discretisations and a simulation",
                 reference_command});
  all.push_back({"check", "a saved run again, compared with what it was: the regression test",
                 check_command});
  all.push_back(
      {"report", "table, report.html and pictures again from a saved run", report_command});
  all.push_back({"evaluate", "p(y, y') of a closed form at points: of a saved run, or written down",
                 evaluate_command});
  return all;
}

std::string names_of(const std::vector<Command>& all) {
  std::vector<std::string> names;
  for (const auto& command : all) names.push_back(command.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void print_overview(const std::vector<Command>& all) {
  fmt::print(
      R"(fpkcheck - stationary density of an oscillator with or without impacts, under
           impulses or white noise or both, by independent methods

    y'' + f(y, y') + g(y) = impulses + noise,    y'(+) = -r y'(-)  at walls

The paper's:  y'' + c y' + k y + mu y^3 = impulses  (y > 0),  a wall at y = 0.

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
A CASE is case1 .. case4 (the paper's Table 1), another oscillator by its name
(bistable, gap, van_der_pol, ..: docs/systems.md) or an ini file like
cases/case1.ini. `fpkcheck COMMAND --help` and `fpkcheck help COMMAND` explain a
command's options; start with `fpkcheck run`.
Exit codes: 0 done; 1 a solver did not reach what was asked, or a check failed;
2 bad input; 130 Ctrl-C, 143 SIGTERM.

)");
  std::vector<std::string_view> subjects;
  for (const auto& feature : problem::unsupported_features()) subjects.push_back(feature.subject);
  fmt::print("{}",
             report::wrap_text(fmt::format("Not treated: {}.", fmt::join(subjects, "; ")), 80));
}

// Every command with its help, and the subjects of `study` as commands of their own.
std::vector<CommandHelp> guide(const std::vector<Command>& all, const methods::Registry& registry) {
  std::vector<CommandHelp> result;
  const auto add = [&](const Command& command, const std::string& subject) {
    Arguments asked{"--help"};
    if (!subject.empty()) asked.insert(asked.begin(), subject);
    const auto help = help_from([&] { command.run({asked, "", registry}); });
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

int dispatch(const Arguments& arguments, const methods::Registry& registry) {
  const auto all = commands(registry);
  if (arguments.empty()) {
    throw InputError(fmt::format("no command (use one of {}; --help explains)", names_of(all)));
  }
  const std::string& name = arguments.front();
  if (name == "help" && arguments.size() > 1) {
    Arguments asked{arguments.begin() + 1, arguments.end()};
    asked.emplace_back("--help");
    return dispatch(asked, registry);
  }
  if (name == "--help" || name == "-h" || name == "help") {
    print_overview(all);
    return kDone;
  }
  if (name == "--version") {
    fmt::print("{}", version_text());
    return kDone;
  }
  // For the shell and for the build; neither is typed.
  if (name == "--complete") {
    const Arguments words{arguments.begin() + 1, arguments.end()};
    for (const auto& word : completions(guide(all, registry), registry, words)) {
      fmt::print("{}\n", word);
    }
    return kDone;
  }
  if (name == "--manual") {
    fmt::print("{}", manual(guide(all, registry)));
    return kDone;
  }
  const auto command = std::ranges::find(all, name, &Command::name);
  if (command == all.end()) {
    if (const std::string text = problem::unsupported_feature_text(name); !text.empty()) {
      throw InputError(fmt::format("{}: {}", base::in_quotes(name), text));
    }
    throw InputError(fmt::format("{} is no command (use one of {}; --help explains)",
                                 base::in_quotes(name), names_of(all)));
  }
  std::string command_line = "fpkcheck";
  for (const auto& argument : arguments) command_line += " " + argument;
  return command->run({{arguments.begin() + 1, arguments.end()}, command_line, registry});
}

}  // namespace

int run_program(const Arguments& arguments) {
  return run_program(arguments, methods::builtin_registry());
}

int run_program(const Arguments& arguments, const methods::Registry& registry) {
  const InterruptionGuard guard;
  note_kept("nothing was written");
  try {
    const int exit_code = dispatch(arguments, registry);
    // A full disk or a closed pipe shows only when the buffers go out.
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw std::runtime_error("standard output could not be written");
    }
    if (!base::stop_requested()) return exit_code;
  } catch (const Interrupted&) {
  } catch (const InputError& error) {
    complain(error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    complain(fmt::format("stopped: {}", methods::kOutOfMemory));
    return kNotReached;
  } catch (const std::exception& error) {
    // A broken environment: a full disk, or a library that fails.
    complain(fmt::format("stopped: {}", error.what()));
    return kNotReached;
  }
  claim_the_end();
  complain(stop_notice());
  return stopped_exit_code(base::stop_signal());
}

}  // namespace fpkcheck::cli
