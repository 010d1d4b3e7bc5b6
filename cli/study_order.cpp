#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/figure_options.hpp"
#include "cli/interruption.hpp"
#include "cli/parse_list.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/study_subjects.hpp"
#include "cli/write_study.hpp"
#include "workflows/study/closure_order.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kOrderUsage = R"(usage: fpkcheck study order CASE [options]

Convergence of closures in the order of their polynomial: status, steps of Newton's method,
condition number, residual, admissibility, distance to the finite-volume solution of the full jump
equation (L1, and in the tail), time. Also reports where the branch of solutions of a formulation
folds before it reaches the problem.
Exit code 0 when every order of the formulation moment gives a density.

examples:
  fpkcheck study order case1
  fpkcheck study order case4 --formulations moment --orders 8,12,16 --out results
  fpkcheck study order case1 --formulations gaussian,gaussian-kf,moment,moment-cut
)";

std::vector<std::string> parse_formulations(const std::string& list,
                                            const methods::Registry& registry) {
  const auto known = study::closure_formulations(registry);
  auto result = parse_list("--formulations", list);
  for (const auto& item : result) {
    if (std::ranges::find(known, item) == known.end()) {
      throw InputError(fmt::format("--formulations {}: '{}' is not a formulation; use {}", list,
                                   item, fmt::join(known, ", ")));
    }
  }
  return result;
}

}  // namespace

int study_order(const CommandCall& call) {
  namespace po = boost::program_options;
  const auto begin = std::chrono::steady_clock::now();
  CommonArguments common;
  std::string formulation_list, order_list;
  const std::string formulations_help = fmt::format(
      "formulations and variants as in ids of solutions, without epc- and -nN: {}; moment-cut is "
      "the unconfined exponent, cut off at an energy",
      fmt::join(study::closure_formulations(call.registry), ", "));
  po::options_description own;
  own.add_options()  //
      ("orders", po::value(&order_list)->value_name("LIST")->default_value("2,4,6,8,10,12"),
       "orders n (degrees of the polynomial), even, from 2")(
          "formulations",
          po::value(&formulation_list)->value_name("LIST")->default_value("gaussian,moment,polar"),
          formulations_help.c_str());
  own.add(make_figure_options(common.figures));
  if (!parse_arguments(
          call.arguments, kOrderUsage,
          add_common_options(
              own, common, "write study-order.json, .csv and a figure to DIR (default: no files)"),
          common.cases)) {
    return kSuccess;
  }
  const study::ClosureOrderStudyOptions options{parse_formulations(formulation_list, call.registry),
                                                parse_integers("--orders", order_list)};
  const auto setup = prepare_study(common);

  ProgressLine line(common.quiet);
  const auto result = study::study_closure_orders(
      setup.problem, options, call.registry, [&](const auto& progress) { line.rewrite(progress); });
  throw_if_interrupted();
  line.erase();
  write_study(common,
              study::output(result, call.command_line, terminal_format(), common.figures.width),
              begin);
  return study_exit_code(common, study::has_converged(result));
}

}  // namespace fpkcheck::cli
