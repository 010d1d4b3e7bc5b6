#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/figure_options.hpp"
#include "cli/parameter_options.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"

namespace fpkcheck::cli {

int solver_command(const CommandCall& call, const methods::Solver& solver) {
  CommonArguments common;
  base::Values values = solver.default_options;
  auto own = make_command_line_options(*solver.option_descriptions, values);
  own.add(make_case_figure_options(common.figures));
  if (!parse_arguments(call.arguments, solver.usage, add_common_options(own, common),
                       common.cases)) {
    return kSuccess;
  }
  return solve_and_report(common, {call.registry.make_method(solver, values)},
                          {.required = RequiredSolutions::all}, call.command_line);
}

}  // namespace fpkcheck::cli
