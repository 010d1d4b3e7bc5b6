#include "approximations/linearisation/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kLinearisationUsage = R"(usage: fpkcheck linearisation CASE ... [options]

Statistical linearisation: a Gaussian density whose mean and variances satisfy the moment equations
of E[y'], E[y y'] and E[y'^2]. Impulses enter like white noise of their mean and intensity. With one
wall, the density is that of y = |z| with a Gaussian z of mean 0 (Zhuravlev's transformation), and
the energy lost in impacts enters the equation of E[y'^2]. Two walls are not supported.

The status is ok if the residual-based error estimate is at most --accuracy, otherwise inaccurate.

examples:
  fpkcheck linearisation case1
  fpkcheck run case1 --methods linearisation,epc,fd,mcs
)";

}  // namespace

Solver linearisation_solver() {
  Solver entry{.name = "linearisation",
               .summary = "statistical linearisation: a Gaussian density",
               .usage = kLinearisationUsage,
               .families = {{.name = "linearisation",
                             .role = transform::SolutionRole::closure,
                             .meaning = "Statistical linearisation: a Gaussian density whose mean "
                                        "and variances satisfy the moment equations.",
                             .default_ids = {"linearisation"},
                             .plot_style = [](const auto&) { return literature_method_style(0); }}},
               .in_default_runs = false};
  return registry_entry_with_solver_traits<linearisation::LinearisationOptions>(
      std::move(entry),
      {.description = linearisation::solver_option_descriptions(),
       .validate = linearisation::validate,
       .identity = linearisation::solution_identity,
       .options_of = linearisation::options_of,
       .solve =
           [](const problem::Problem& problem, const linearisation::LinearisationOptions& options,
              const SolverInputContext& context) {
             auto solution = linearisation::solve_moment_equations(problem, options);
             set_closure_error_estimate(context, problem, options.accuracy, solution);
             return solution;
           },
       .unsupported_reason = linearisation::unsupported_reason});
}

}  // namespace fpkcheck::methods
