#include "approximations/averaging/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kAveragingUsage = R"(usage: fpkcheck averaging CASE ... [options]

Stochastic averaging of the energy envelope: the density depends only on the energy and on the well.
On every orbit of the undamped motion, the losses by damping and impacts balance the energy input by
the excitation. The method is exact in the limit of weak damping, weak impact losses and weak
excitation.
  white  impulses as white noise of their intensity: a diffusion of the energy
  kf     jumps of the energy at impulses, averaged over the phase of the orbit

The status is ok if the residual-based error estimate is at most --accuracy, otherwise inaccurate.

examples:
  fpkcheck averaging case1
  fpkcheck averaging bistable --equation white
  fpkcheck run case1 --methods averaging,epc,fd,mcs
)";

transform::PlotStyle averaging_style(const transform::SolutionIdentity& identity) {
  transform::PlotStyle plot_style = literature_method_style(1);
  if (identity.equation == problem::DensityEquation::white) plot_style.dash = "(3,6)";
  return plot_style;
}

}  // namespace

Solver averaging_solver() {
  Solver entry{.name = "averaging",
               .summary = "stochastic averaging of the energy envelope",
               .usage = kAveragingUsage,
               .families = {{.name = "averaging",
                             .role = transform::SolutionRole::closure,
                             .meaning = "Stochastic averaging of the energy envelope: a density of "
                                        "the energy and of the well.",
                             .default_ids = {"averaging-white", "averaging-kf"},
                             .plot_style = averaging_style}},
               .in_default_runs = false};
  return registry_entry_with_solver_traits<averaging::AveragingOptions>(
      std::move(entry),
      {.description = averaging::solver_option_descriptions(),
       .validate = averaging::validate,
       .identity = averaging::solution_identity,
       .options_of = averaging::options_of,
       .solve =
           [](const problem::Problem& problem, const averaging::AveragingOptions& options,
              const SolverInputContext& context) {
             auto solution = averaging::solve_averaged_equation(problem, options);
             set_closure_error_estimate(context, problem, options.accuracy, solution);
             return solution;
           },
       .unsupported_reason = averaging::unsupported_reason});
}

}  // namespace fpkcheck::methods
