#include "approximations/cumulant/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kCumulantUsage = R"(usage: fpkcheck cumulant CASE ... [options]

Cumulant neglect: the moment equations of E[y^p y'^q], p + q <= N, closed by setting the cumulants
above the order N to 0, with the density of a Gram-Charlier series. Impulses enter exactly, by their
moments up to the order N. The force, the damping and the squares of factors must be polynomials.
With one wall, the cumulants are those of (z, z') with y = |z| (Zhuravlev's transformation). Two
walls are not supported.

The status is inadmissible if the Gram-Charlier density is negative; the moments then still satisfy
the equations. Otherwise the status is ok if the residual-based error estimate is at most
--accuracy.

examples:
  fpkcheck cumulant duffing --order 6
  fpkcheck run case1 --methods cumulant,epc,fd,mcs
)";

// The drawn fraction of the dashed line increases with the order.
transform::PlotStyle cumulant_style(const transform::SolutionIdentity& identity) {
  transform::PlotStyle plot_style = literature_method_style(2);
  plot_style.dash = identity.order == 2 ? "(2,4)" : identity.order == 4 ? "(8,3)" : "(16,3,3,3)";
  return plot_style;
}

}  // namespace

Solver cumulant_solver() {
  Solver entry{.name = "cumulant",
               .summary = "cumulant neglect: closed moment equations",
               .usage = kCumulantUsage,
               .families = {{.name = "cumulant",
                             .role = transform::SolutionRole::closure,
                             .meaning = "Cumulant neglect: moment equations without the cumulants "
                                        "above the order n, and a Gram-Charlier density.",
                             .default_ids = {"cumulant-n2", "cumulant-n4", "cumulant-n6"},
                             .plot_style = cumulant_style}},
               .in_default_runs = false};
  return registry_entry_with_solver_traits<cumulant::CumulantOptions>(
      std::move(entry),
      {.description = cumulant::solver_option_descriptions(),
       .validate = cumulant::validate,
       .identity = cumulant::solution_identity,
       .options_of = cumulant::options_of,
       .solve =
           [](const problem::Problem& problem, const cumulant::CumulantOptions& options,
              const SolverInputContext& context) {
             auto solution = cumulant::solve_moment_equations(problem, options);
             set_closure_error_estimate(context, problem, options.accuracy, solution);
             return solution;
           },
       .unsupported_reason = cumulant::unsupported_reason});
}

}  // namespace fpkcheck::methods
