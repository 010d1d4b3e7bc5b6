#include <chrono>

#include "cli/choice.hpp"
#include "cli/command_line.hpp"
#include "cli/interruption.hpp"
#include "cli/lists.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/put_study.hpp"
#include "cli/simulation_options.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/studies.hpp"
#include "compare/study/grid.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck study grid CASE [options]

Finite differences on finer and finer grids, for several orders of the scheme: the distance of the
marginals to their Richardson limit, the orders observed over every three levels, the limits of the
moments; and beside them what the closures and the simulation reach in which time, so that one
sees which method to use for which accuracy.
Exit code 0 when there is a limit, and the finest grids give a density.

examples:
  fpkcheck study grid case1
  fpkcheck study grid case4 --orders 5,7 --levels 6 --out results
  fpkcheck study grid case1 --origin-refinement 16                 (the jump at the origin resolved)
  fpkcheck study grid case1 --equation km4 --impact delta          (the equation of the closure)
)";

// The finest grid of each order: coarse ones are looked at.
bool reached(const nlohmann::ordered_json& report) {
  const auto& rows = report.at("rows");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool finest = k + 1 == rows.size() || rows[k + 1].at("order") != rows[k].at("order");
    if (finest && rows[k].at("status") == "failed") return false;
  }
  return !report.at("truth").at("order").is_null();
}

}  // namespace

int study_grid(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  const auto begin = std::chrono::steady_clock::now();
  CommonArguments common;
  compare::GridStudyOptions options;
  std::string equation_name, impact_name, order_list;
  po::options_description own;
  own.add_options()  //
      ("equation", po::value(&equation_name)->value_name("E")->default_value("kf"),
       "white, km4, km4-pade or kf")(
          "impact", po::value(&impact_name)->value_name("I")->default_value("map"),
          "map: the exact impact; delta: the paper's, first order in 1-r")(
          "orders", po::value(&order_list)->value_name("LIST")->default_value("3,5,7"),
          "orders of the transport terms, 2 .. 8; the highest gives the limit")(
          "levels", po::value(&options.levels)->value_name("N")->default_value(options.levels),
          "grids per order, each with cells narrower by sqrt 2")(
          "coarsest",
          po::value(&options.coarsest)->value_name("F")->default_value(options.coarsest),
          "refinement of the first level; 1 is the automatic grid")(
          "origin-refinement",
          po::value<double>()->value_name("F")->notifier(
              [&options](double value) { options.origin_refinement = value; }),
          "cells at the origin are F times narrower than far from it (default: 16 for strong losses, else 1)");
  own.add(simulation_options(options.simulation));
  if (!parse(arguments, kUsage,
             with_common_options(own, common, "write study-grid.json, .csv and a picture there"),
             common.cases)) {
    return kDone;
  }
  using fd_fpk::Equation, problem::Impact;
  options.equation = choice(equation_name, "--equation",
                            {Equation::white, Equation::km4, Equation::km4_pade, Equation::kf});
  options.impact = choice(impact_name, "--impact", {Impact::map, Impact::delta});
  options.orders = integers("--orders", order_list);
  compare::validate(options);
  const auto start = start_of_study(common);
  const auto& problem = start.problem;

  const InterruptionGuard guard;
  ProgressLine line(common.quiet);
  const auto report = compare::study_grid(command_line, problem, options,
                                          [&](const auto& progress) { line.show(progress); });
  throw_if_interrupted();
  line.clear();
  put_study(common,
            {.stem = "study-grid",
             .report = report,
             .table = compare::grid_table(report, terminal_format()),
             .csv = compare::grid_csv(report),
             .figure = compare::grid_figure(report, "study-grid")},
            begin);
  return reached(report) ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
