#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/parameter_options.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "methods/mcs.hpp"
#include "parameters/input_error.hpp"
#include "process/stop.hpp"

namespace fpkcheck::cli {
namespace {

boost::program_options::options_description file_options(methods::SimulationControl& control) {
  namespace po = boost::program_options;
  po::options_description files;
  files.add_options()  //
      ("checkpoint", po::value(&control.checkpoint)->value_name("FILE"),
       "write the state there every half minute and in the end")(
          "resume", po::value(&control.resume)->value_name("FILE"),
          "go on from a checkpoint: the result is that of a run without interruption");
  return files;
}

}  // namespace

int mcs_command(const Call& call, const methods::Solver& solver) {
  CommonArguments common;
  parameters::Values values = solver.usual_options;
  methods::SimulationControl control{.stop = process::stop_requested,
                                     .warn = [](const std::string& text) { complain(text); }};
  auto own = options_for(*solver.parameters, values);
  own.add(file_options(control));
  if (!parse(call.arguments, solver.usage, with_common_options(own, common), common.cases)) {
    return kDone;
  }
  if (common.cases.size() > 1 && !(control.checkpoint.empty() && control.resume.empty())) {
    throw InputError(
        "--checkpoint and --resume with several cases (a file holds one: name one case)");
  }
  return solve_and_report(common,
                          {methods::under_control(call.registry.method(solver, values), control)},
                          {.on_interruption = OnInterruption::finish_early}, call.command_line);
}

}  // namespace fpkcheck::cli
