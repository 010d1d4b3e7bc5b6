#include "methods/mcs.hpp"

#include <fmt/format.h>

#include <utility>

#include "control_variates/solve.hpp"
#include "mcs/applicability.hpp"
#include "mcs/options.hpp"
#include "mcs/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/method_interface.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kMcsUsage = R"(usage: fpkcheck mcs CASE ... [options]

Simulates the impact system: impulses at their exact times, impacts located by root finding,
independent streams whose differences give the standard errors and 95 % intervals. The same seed
gives the same result, bit for bit, for any number of threads.

The simulation ends after --time, or as soon as --samples and --target-error are reached. Ctrl-C
ends the simulation within about a second and keeps the result so far; a second Ctrl-C ends the
program.

--controlled uses control variates, as `fpkcheck run` does: E[f] is the mean of f + L h for any
function h of the phase plane. With h from the backward equation, f + L h has little variance.

--tails splits the trajectories that reach high energies (rare-event splitting): densities down to
1e-8 of their peak and below, with intervals, in the time of a run without --tails.

examples:
  fpkcheck mcs case1 --seed 7
  fpkcheck mcs case1 --target-error 3e-4 --json
  fpkcheck mcs case1 --samples 1e7
  fpkcheck mcs case1 --controlled
  fpkcheck mcs case1 --tails --out tails
  fpkcheck mcs case1 --equation white
  fpkcheck mcs case1 --time 1e9 --checkpoint state        then, after an interruption:
  fpkcheck mcs case1 --time 1e9 --checkpoint state --resume state
  mpirun -n 64 fpkcheck mcs case1 --time 1e11 --streams 4096        the same bits, in less time
)";

transform::Solution solve_by_simulation(const problem::Problem& problem,
                                        const mcs::SimulationOptions& options,
                                        const SolverInputContext& context) {
  mcs::SimulationOptions axis_options = options;
  axis_options.y_edges = context.axes.y_edges;
  axis_options.v_edges = context.axes.v_edges;
  // Without a callback the simulation does not compute its sampling errors after every round.
  if (context.progress)
    axis_options.progress = [&](const mcs::SimulationProgress& at) {
      context.progress(at.fraction, at.y_l1 && at.ydot_l1
                                        ? fmt::format("sampling L1 {:.1e} in p(y), {:.1e} in p(y')",
                                                      *at.y_l1, *at.ydot_l1)
                                        : std::string());
    };
  if (options.controlled)
    return control_variates::simulate_with_control_variates(problem, {.simulation = axis_options});
  return mcs::simulate_stationary_density(problem, axis_options).solution;
}

// In a list of methods the simulation is the reference and should have small sampling errors. For
// the density equation `kf` the simulation uses control variates, which the density equation
// `white` does not permit.
std::optional<mcs::SimulationOptions> options_with_control_variates(std::string_view id) {
  auto options = mcs::options_of(id);
  if (options) options->controlled = options->equation == mcs::DensityEquation::kf;
  return options;
}

}  // namespace

Method simulation_with_runtime_settings(Method simulation,
                                        const SimulationRuntimeSettings& control) {
  mcs::SimulationOptions options =
      mcs::solver_option_descriptions().read(simulation.options, "options");
  options.checkpoint = control.checkpoint;
  options.resume = control.resume;
  options.stop = control.stop;
  options.warn = control.warn;
  options.process_group = control.process_group;
  simulation.solve = [options = std::move(options)](const problem::Problem& problem,
                                                    const SolverInputContext& context) {
    return solve_in_wall_coordinates(
        problem, context,
        [&](const problem::Problem& transformed) {
          return mcs::unsupported_reason(transformed, options);
        },
        [&](const problem::Problem& transformed, const SolverInputContext& transformed_context) {
          return solve_by_simulation(transformed, options, transformed_context);
        });
  };
  return simulation;
}

Solver mcs_solver() {
  Solver entry{.name = "mcs",
               .summary = "Monte Carlo simulation of the impact system",
               .usage = kMcsUsage,
               .families = {{.name = "mcs",
                             .role = transform::SolutionRole::simulation,
                             .meaning = "Monte Carlo simulation of the impact system; bands are "
                                        "95 % confidence intervals.",
                             .default_ids = {"mcs"},
                             .plot_style = simulation_style}},
               .uses_all_processors = true,
               .run_options = {"time", "seed", "threads"}};
  return registry_entry_with_solver_traits<mcs::SimulationOptions>(
      std::move(entry), {.description = mcs::solver_option_descriptions(),
                         .validate = mcs::validate,
                         .identity = mcs::solution_identity,
                         .options_of = options_with_control_variates,
                         .solve = solve_by_simulation,
                         .check = mcs::require_valid_simulation,
                         .unsupported_reason = mcs::unsupported_reason});
}

}  // namespace fpkcheck::methods
