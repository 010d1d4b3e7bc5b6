#include "epc/options.hpp"
#include "epc/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kEpcUsage = R"(usage: fpkcheck epc CASE ... [options]

Exponential-polynomial closure: a density C exp(Q_n), Q_n a polynomial of degree n, determined by
weak equations. Three formulations:
  gaussian   the paper's closure: p(z, z') on the whole plane, projections (23) with Gaussian
             weights, Kramers-Moyal series truncated after the fourth derivative, impact as a delta
             function. Where Newton's method finds no root, the solver follows the branch of
             solutions from the exact density of white noise at r = 1 past its folds (branch in
             summary.json)
  moment     p(y, y') on y >= 0, exact moment equations of the impact process
  polar      as moment, with Q_n a polynomial of amplitude and phase, which represents the jump of
             the density at the origin after impacts with losses. Where the mass comes to rest in
             contact with a wall: amplitude and velocity, with the probability of contact
The error against the full problem is estimated from the residuals of the density in the stationary
equation, weighted by solutions of the backward equation: in L1 of p(y) and p(y'), and for each
moment. Where this gives no estimate, the distance to the reference of the run is used. The status:
  ok             the density meets the equations, has decayed on the whole edge of its support
                 (gaussian: also meets the balance of power and is close to that of order n-2), and
                 its error estimate is at most --accuracy
  inaccurate     as ok, but the error estimate is larger than --accuracy, or unknown
  inadmissible   the equations are met, but not by such a density (condition (19) of the paper),
                 or by a spurious one
  not_converged  the equations are not met (gaussian with kf: or depend on the radius of the disc
                 of the jump integral)

examples:
  fpkcheck epc case1 --order 6
  fpkcheck epc case1 case4 --formulation moment --order 8
  fpkcheck epc case2 --order 8 --json
  fpkcheck epc case2 --order 8 --equation kf
)";

MethodFamily closure_family(const std::string& name, const std::string& meaning,
                            std::vector<std::string> default_ids) {
  return {name, transform::SolutionRole::closure, meaning, std::move(default_ids), closure_style};
}

}  // namespace

Solver epc_solver() {
  Solver entry{
      .name = "epc",
      .summary = "exponential-polynomial closure, the paper's equations (17)-(26)",
      .usage = kEpcUsage,
      .families =
          {closure_family(
               "epc-gaussian",
               "Exponential-polynomial closure of the paper: p = C exp(Q_n) with a "
               "polynomial of degree n, projected with Gaussian weights.",
               {"epc-gaussian-n2", "epc-gaussian-n4", "epc-gaussian-n6", "epc-gaussian-n8"}),
           closure_family("epc-moment",
                          "The same form with the exact moment equations of the impact process "
                          "on the half-plane y >= 0.",
                          {"epc-moment-n4", "epc-moment-n8", "epc-moment-n12"}),
           closure_family("epc-polar",
                          "As epc-moment, but with a polynomial of amplitude and phase, or of "
                          "amplitude and velocity.",
                          {"epc-polar-n4", "epc-polar-n6", "epc-polar-n8"})},
      .run_options = {"accuracy"}};
  return registry_entry_with_solver_traits<epc::ClosureOptions>(
      std::move(entry), {.description = epc::solver_option_descriptions(),
                         .validate = epc::validate,
                         .identity = epc::solution_identity,
                         .options_of = epc::options_of,
                         .solve =
                             [](const problem::Problem& problem, const epc::ClosureOptions& options,
                                const SolverInputContext& context) {
                               auto solution = epc::solve_closure(problem, options).solution;
                               if (options.accuracy) {
                                 set_closure_error_estimate(context, problem, *options.accuracy,
                                                            solution);
                               }
                               return solution;
                             },
                         .unsupported_reason = epc::unsupported_reason});
}

}  // namespace fpkcheck::methods
