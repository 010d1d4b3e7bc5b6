#include "cli/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "compare/summary.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

using Arguments = std::vector<std::string>;

struct Command {
  const char* name;
  const char* summary;
  int (*run)(const Arguments&, const std::string& command_line);
};

constexpr Command kCommands[] = {
    {"run", "all methods on all cases, compared: tables, report.html, pictures", run_command},
    {"epc", "exponential-polynomial closure, the paper's equations (17)-(26)", epc_command},
    {"fd", "finite differences for the (generalised) Fokker-Planck-Kolmogorov equation",
     fd_command},
    {"mcs", "Monte Carlo simulation of the impact system itself", mcs_command},
    {"study", "what order, step and regularisation do: convergence, cost, growth", study_command},
    {"reference", "reference values, agreed on by two discretisations and a simulation",
     reference_command},
    {"check", "a saved run again, compared with what it was: the regression test", check_command},
    {"report", "table, report.html and pictures again from a saved run", report_command},
};

void print_overview() {
  fmt::print(
      R"(fpkcheck - stationary density of a vibro-impact Duffing oscillator under Poisson impulses,
           by independent methods that are compared with one another

    y'' + c y' + k y + mu y^3 = impulses  (y > 0),      y'(+) = -r y'(-)  at y = 0

usage: fpkcheck COMMAND [CASE ...] [options]

commands:
)");
  for (const auto& command : kCommands) fmt::print("  {:<9} {}\n", command.name, command.summary);
  fmt::print(R"(
A CASE is case1 .. case4 (the paper's Table 1) or an ini file like cases/case1.ini.
`fpkcheck COMMAND --help` explains a command's options; start with `fpkcheck run`.
Exit codes: 0 done; 1 a solver did not reach what was asked, or a check failed;
2 bad input; 130 Ctrl-C.
)");
}

int dispatch(const Arguments& arguments) {
  if (arguments.empty())
    throw InputError(
        "no command (use run, epc, fd, mcs, study, reference, check or report; --help explains)");
  const std::string& name = arguments.front();
  if (name == "--help" || name == "-h" || name == "help") {
    print_overview();
    return kDone;
  }
  if (name == "--version") {
    fmt::print("fpkcheck {}\n", compare::program_version());
    return kDone;
  }
  const auto* const command =
      std::ranges::find_if(kCommands, [&](const Command& c) { return name == c.name; });
  if (command == std::end(kCommands)) {
    throw InputError(fmt::format(
        "'{}' is no command (use run, epc, fd, mcs, study, reference, check or report; --help explains)",
        name));
  }
  std::string command_line = "fpkcheck";
  for (const auto& argument : arguments) command_line += " " + argument;
  return command->run(Arguments(arguments.begin() + 1, arguments.end()), command_line);
}

}  // namespace

int run_program(const Arguments& arguments) {
  try {
    const int exit_code = dispatch(arguments);
    // A full disk or a closed pipe shows only when the buffers go out.
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw std::runtime_error("standard output could not be written");
    }
    return exit_code;
  } catch (const Interrupted& interruption) {
    fmt::print(stderr, "fpkcheck: {}\n", interruption.what());
    return kInterrupted;
  } catch (const InputError& error) {
    fmt::print(stderr, "fpkcheck: {}\n", error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    // A broken environment: no memory, a full disk.
    fmt::print(stderr, "fpkcheck: stopped: {}\n", error.what());
    return kNotReached;
  }
}

}  // namespace fpkcheck::cli
