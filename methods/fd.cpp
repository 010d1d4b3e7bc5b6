#include "fd_fpk/applicability.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kFdUsage = R"(usage: fpkcheck fd CASE ... [options]

Conservative finite volumes of fifth or seventh order (method of lines) for the stationary density
between the walls. CVODE with KLU integrates to the stationary state; the null vector of the same
operator checks the result. The excitation term of the equation:
  white     Gaussian white noise of the same intensity
  km4       the Kramers-Moyal series truncated after the fourth derivative, with a fixed step l of
            the fourth difference. With l = grid step the problem is ill-posed: status ill_posed
  km4-pade  the Pade approximant of that series: well-posed without a length
  kf        the full jump integral (Kolmogorov-Feller equation), for every impulse law

Where impulses are rare, losses strong, or the mass comes to rest in contact with a wall, kf is
solved along the characteristics of the motion instead (--transport). Every solution has an error
estimate. While the estimate exceeds 1e-4, the solver refines the grid if a finer grid is expected
to reach 1e-4 within the time limit. A solution whose estimate exceeds --accuracy is not ok.

examples:
  fpkcheck fd case1
  fpkcheck fd case1 --equation km4 --impact delta                (the equation of the closure)
  fpkcheck fd case1 --equation km4 --regularisation-length 0     (status ill_posed)
  fpkcheck fd case4 --stepper direct --order 7 --refinement 1.5
  fpkcheck fd case1 --until 20 --snapshots 80 --out transient    (the density over time)
  fpkcheck fd bistable --until 40 --start-mean-y 1               (two wells, from one of them)
)";

}  // namespace

Solver fd_solver() {
  Solver entry{
      .name = "fd",
      .summary = "finite volumes for the (generalised) Fokker-Planck-Kolmogorov equation",
      .usage = kFdUsage,
      .families = {{.name = "fd",
                    .role = transform::SolutionRole::equation,
                    .meaning = "Finite volumes for the density equation that the id names.",
                    .default_ids = {"fd-white", "fd-km4-delta", "fd-km4", "fd-kf"},
                    .plot_style = density_equation_style}},
      .run_options = {"max_seconds"}};
  return registry_entry_with_solver_traits<fd_fpk::FiniteVolumeOptions>(
      std::move(entry),
      {.description = fd_fpk::solver_option_descriptions(),
       .validate = fd_fpk::validate,
       .identity = fd_fpk::solution_identity,
       .options_of = fd_fpk::options_of,
       .solve =
           [](const problem::Problem& problem, const fd_fpk::FiniteVolumeOptions& options,
              const SolverInputContext&) {
             return fd_fpk::solve_stationary_density(problem, options).solution;
           },
       .unsupported_reason = fd_fpk::unsupported_reason,
       .options_of_identical_equation = fd_fpk::options_of_identical_equation});
}

}  // namespace fpkcheck::methods
