#include <algorithm>
#include <exception>
#include <string>

#include "base/input_error.hpp"
#include "base/mpi/communicator.hpp"
#include "base/process/stop_request.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/terminal.hpp"
#include "methods/mcs.hpp"
#include "methods/run_cases.hpp"

namespace fpkcheck::cli {
namespace {

boost::program_options::options_description checkpoint_options(
    methods::SimulationRuntimeSettings& control) {
  namespace po = boost::program_options;
  po::options_description files;
  files.add_options()  //
      ("checkpoint", po::value(&control.checkpoint)->value_name("FILE"),
       "write the state of the simulation to FILE every 30 s and at the end (default: no file)")(
          "resume", po::value(&control.resume)->value_name("FILE"),
          "continue from the checkpoint in FILE; the result equals that of an uninterrupted run");
  return files;
}

void refuse_control_variates(const base::Values& values) {
  const auto controlled = std::ranges::find(values, "controlled", &base::NamedParameterValue::name);
  if (controlled == values.end() || controlled->value != base::Value(true)) return;
  throw InputError("--controlled with mpirun: control variates need a single process; omit one");
}

// Simulates the streams of an MPI rank other than the first rank of a simulation.
int simulate_streams_of_rank(const CommonCommandArguments& common,
                             const methods::Method& simulation) {
  for (const auto& problem : load_cases(common)) {
    methods::solve_with_method(simulation, problem, {compare::comparison_bins(problem), {}});
  }
  return kSuccess;
}

}  // namespace

int mcs_command(const CommandInvocation& call, const methods::Solver& solver) {
  CommonCommandArguments common;
  base::Values values = solver.default_options;
  methods::SimulationRuntimeSettings control{
      .stop = base::stop_requested, .warn = [](const std::string& text) { print_message(text); }};
  auto own = make_command_line_options(*solver.option_descriptions, values);
  own.add(checkpoint_options(control));
  own.add(make_case_figure_options(common.figures));
  if (!parse_case_arguments(call.arguments, solver.usage, own, common)) return kSuccess;
  if (common.cases.size() > 1 && !(control.checkpoint.empty() && control.resume.empty())) {
    throw InputError(
        "--checkpoint or --resume with several cases: a file stores one case; name one case");
  }
  const auto solve = [&] {
    const auto simulation = methods::simulation_with_runtime_settings(
        call.registry.make_method(solver, values), control);
    return control.process_group.part > 0
               ? simulate_streams_of_rank(common, simulation)
               : solve_and_report(common, {simulation},
                                  {.interruption_policy = control.process_group.parts == 1
                                                              ? InterruptionPolicy::finish_early
                                                              : InterruptionPolicy::abort},
                                  call.command_line);
  };
  if (!base::Communicator::launched_by_mpi()) return solve();

  refuse_control_variates(values);
  const auto ranks = base::Communicator::initialise_mpi();
  control.process_group = {.part = ranks->process_rank(),
                           .parts = ranks->process_count(),
                           .gather = [&ranks](const std::string& text) {
                             return ranks->gather(text, throw_if_interrupted);
                           }};
  try {
    return solve();
  } catch (const std::exception& error) {
    // After a failure MPI_Abort is called, since the other MPI ranks would wait for the failed
    // rank.
    print_message(error.what());
    ranks->abort(kFailure);
    return kFailure;
  }
}

}  // namespace fpkcheck::cli
