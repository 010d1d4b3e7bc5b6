#include "approximations/path_integration/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr const char* kPathIntegrationUsage = R"(usage: fpkcheck path CASE ... [options]

Path integration: the density after a short time follows from the density before by the
Chapman-Kolmogorov equation, and the stationary density is the fixed point. The short-time law
alternates impulses and noise, which change the velocity, and the motion with impacts.
  white  impulses as white noise of their intensity
  kf     Poisson law of the impulses

The density is a quintic spline, extrapolated to the time step 0. The error estimate compares three
grids. Grids are refined until the estimate is at most 1e-4, up to the largest grid. A solution
whose estimate exceeds --accuracy is not ok.

examples:
  fpkcheck path case1
  fpkcheck path duffing --equation white --intervals 116
  fpkcheck run case1 --methods path,fd,mcs
)";

transform::PlotStyle path_integration_style(const transform::SolutionIdentity& identity) {
  transform::PlotStyle plot_style = density_equation_style(identity);
  plot_style.colour = "#CC79A7";
  plot_style.width = 2;
  plot_style.layer = 1;
  if (identity.equation == problem::DensityEquation::kf) plot_style.dash = "(10,3)";
  plot_style.symbol = "triangle-down-open";
  return plot_style;
}

}  // namespace

Solver path_integration_solver() {
  Solver entry{.name = "path",
               .summary = "path integration with splines and the short-time law",
               .usage = kPathIntegrationUsage,
               .families = {{.name = "path",
                             .role = transform::SolutionRole::equation,
                             .meaning = "Path integration: the fixed point of the transition over "
                                        "a short time.",
                             .default_ids = {"path-white", "path-kf"},
                             .plot_style = path_integration_style}},
               .in_default_runs = false};
  return registry_entry_with_solver_traits<path_integration::PathIntegrationOptions>(
      std::move(entry),
      {.description = path_integration::solver_option_descriptions(),
       .validate = path_integration::validate,
       .identity = path_integration::solution_identity,
       .options_of = path_integration::options_of,
       .solve =
           [](const problem::Problem& problem,
              const path_integration::PathIntegrationOptions& options, const SolverInputContext&) {
             return path_integration::solve_by_path_integration(problem, options);
           },
       .unsupported_reason = path_integration::unsupported_reason});
}

}  // namespace fpkcheck::methods
