#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/interruption.hpp"
#include "cli/lists.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/put_study.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/studies.hpp"
#include "compare/study/order.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck study order CASE [options]

What becomes of a closure as the order of its polynomial grows: status, steps of Newton's method,
condition, residual, admissibility, distance to finite differences of the full jump equation (L1,
and in the tail), time; and where the branch of solutions of a formulation folds before it reaches
the problem asked for.
Exit code 0 when every order of the formulation moment gives a density.

examples:
  fpkcheck study order case1
  fpkcheck study order case4 --formulations moment --orders 8,12,16 --out results
  fpkcheck study order case1 --formulations gaussian,gaussian-kf,moment,moment-cut
)";

constexpr std::string_view kFormulations[] = {
    "gaussian", "gaussian-white", "gaussian-kf", "moment", "moment-cut", "moment-white", "polar"};

std::vector<std::string> formulations(const std::string& list) {
  auto result = items("--formulations", list);
  for (const auto& item : result) {
    if (std::ranges::find(kFormulations, item) == std::end(kFormulations)) {
      throw InputError(fmt::format("--formulations {} ('{}' is none) use {}", list, item,
                                   fmt::join(kFormulations, ", ")));
    }
  }
  return result;
}

// The formulation that is to converge; the others are looked at.
bool reached(const nlohmann::ordered_json& report) {
  for (const auto& row : report.at("rows")) {
    if (row.at("formulation") == "moment" && row.at("status") != "ok") return false;
  }
  return report.at("reference").at("status") == "ok";
}

}  // namespace

int study_order(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  const auto begin = std::chrono::steady_clock::now();
  CommonArguments common;
  std::string formulation_list, order_list;
  po::options_description own;
  own.add_options()  //
      ("orders", po::value(&order_list)->value_name("LIST")->default_value("2,4,6,8,10,12"),
       "degrees n of the polynomial, even")(
          "formulations",
          po::value(&formulation_list)->value_name("LIST")->default_value("gaussian,moment,polar"),
          "as in the ids of solutions, without epc- and -nN: gaussian, gaussian-white, gaussian-kf, "
          "moment, moment-cut, moment-white, polar; moment-cut: the bare exponent, cut off");
  if (!parse(arguments, kUsage,
             with_common_options(own, common, "write study-order.json, .csv and a picture there"),
             common.cases)) {
    return kDone;
  }
  const compare::OrderStudyOptions options{formulations(formulation_list),
                                           integers("--orders", order_list)};
  const auto start = start_of_study(common);
  const auto& problem = start.problem;

  const InterruptionGuard guard;
  ProgressLine line(common.quiet);
  const auto report = compare::study_orders(command_line, problem, options,
                                            [&](const auto& progress) { line.show(progress); });
  throw_if_interrupted();
  line.clear();
  put_study(common,
            {.stem = "study-order",
             .report = report,
             .table = compare::order_table(report, terminal_format()),
             .csv = compare::order_csv(report),
             .figure = compare::order_figure(report, "study-order")},
            begin);
  return reached(report) ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
