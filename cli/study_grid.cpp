#include <chrono>

#include "cli/command_line.hpp"
#include "cli/figure_options.hpp"
#include "cli/interruption.hpp"
#include "cli/parameter_options.hpp"
#include "cli/parse_list.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/study_subjects.hpp"
#include "cli/write_study.hpp"
#include "fd_fpk/options.hpp"
#include "workflows/study/grid.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kGridUsage = R"(usage: fpkcheck study grid CASE [options]

Grid convergence of the finite volumes for several orders of the scheme: distances of the marginal
densities to their Richardson limit, the observed order over each three grid levels, and limits of
the moments. Also shows error and time of closures and simulation, for the choice of a method.
Exit code 0 when the limit exists and the finest grids give a density.

examples:
  fpkcheck study grid case1
  fpkcheck study grid case4 --orders 5,7 --levels 6 --out results
  fpkcheck study grid case1 --origin-refinement 16                 (resolves the jump at the origin)
  fpkcheck study grid case1 --equation km4 --impact delta          (the equation of the closure)
)";

}  // namespace

int study_grid(const CommandCall& call) {
  namespace po = boost::program_options;
  const auto begin = std::chrono::steady_clock::now();
  CommonArguments common;
  study::GridStudyOptions options;
  const auto& grids = fd_fpk::description();
  base::Values grid_values{{"equation", std::string(name(options.equation))},
                           {"impact", std::string(name(options.impact))}};
  std::string order_list;
  po::options_description own;
  own.add(
      make_command_line_options(grids, {"equation", "impact", "origin_refinement"}, grid_values));
  own.add_options()  //
      ("orders", po::value(&order_list)->value_name("LIST")->default_value("3,5,7"),
       "orders of the transport terms, 2 .. 8; the highest order gives the limit")(
          "levels", po::value(&options.levels)->value_name("N")->default_value(options.levels),
          "number of grids for each order; cells are narrower by sqrt(2) from level to level")(
          "coarsest",
          po::value(&options.coarsest)->value_name("F")->default_value(options.coarsest),
          "refinement factor of the first level; 1 is the automatic grid");
  for (const auto& solver : call.registry.solvers()) {
    own.add(make_command_line_options(*solver.option_descriptions, solver.run_options,
                                      options.simulation));
  }
  own.add(make_figure_options(common.figures));
  if (!parse_arguments(
          call.arguments, kGridUsage,
          add_common_options(own, common,
                             "write study-grid.json, .csv and a figure to DIR (default: no files)"),
          common.cases)) {
    return kSuccess;
  }
  fd_fpk::Options scheme;
  for (const auto& [key, value] : grid_values) {
    grids.assign(scheme, *grids.find(key), value, "--" + key);
  }
  options.equation = scheme.equation;
  options.impact = scheme.impact;
  options.origin_refinement = scheme.origin_refinement;
  options.orders = parse_integers("--orders", order_list);
  study::validate(options);
  const auto setup = prepare_study(common);

  ProgressLine line(common.quiet);
  const auto result = study::study_grid(setup.problem, options, call.registry,
                                        [&](const auto& progress) { line.rewrite(progress); });
  throw_if_interrupted();
  line.erase();
  write_study(common,
              study::output(result, call.command_line, terminal_format(), common.figures.width),
              begin);
  return study_exit_code(common, study::has_converged(result));
}

}  // namespace fpkcheck::cli
