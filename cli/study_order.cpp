#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/studies.hpp"
#include "compare/figure/drawing.hpp"
#include "compare/report.hpp"
#include "compare/run_directory.hpp"
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

std::vector<std::string> items(const std::string& list) {
  std::vector<std::string> result;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');) result.push_back(item);
  return result;
}

// Each once, as they come.
template <class Item>
void add(std::vector<Item>& list, const Item& item) {
  if (std::ranges::find(list, item) == list.end()) list.push_back(item);
}

std::vector<std::string> formulations(const std::string& list) {
  std::vector<std::string> result;
  for (const auto& item : items(list)) {
    if (std::ranges::find(kFormulations, item) == std::end(kFormulations)) {
      throw InputError(fmt::format("--formulations {} ('{}' is none) use {}", list, item,
                                   fmt::join(kFormulations, ", ")));
    }
    add(result, item);
  }
  if (result.empty())
    throw InputError("--formulations: the list is empty (use one such as moment)");
  return result;
}

std::vector<int> orders(const std::string& list) {
  std::vector<int> result;
  for (const auto& item : items(list)) {
    int order = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), order);
    if (error != std::errc{} || end != item.data() + item.size()) {
      throw InputError(
          fmt::format("--orders {} ('{}' is no number) use a list such as 2,4,6", list, item));
    }
    add(result, order);
  }
  if (result.empty()) throw InputError("--orders: the list is empty (use one such as 2,4,6)");
  return result;
}

// The formulation that is to converge; the others are looked at.
bool reached(const nlohmann::ordered_json& report) {
  for (const auto& row : report.at("rows")) {
    if (row.at("formulation") == "moment" && row.at("status") != "ok") return false;
  }
  return report.at("reference").at("status") == "ok";
}

void write(const std::filesystem::path& directory, const nlohmann::ordered_json& report) {
  compare::write_file(directory / "study-order.json", compare::json_text(report) + '\n');
  compare::write_file(directory / "study-order.csv", compare::order_csv(report));
  const std::string stem = "study-order";
  compare::remove_pictures_of(directory / "figures", stem);
  for (const auto& warning : compare::write_pictures(
           directory / "figures", stem, compare::order_figure(report, stem), "gnuplot")) {
    fmt::print(stderr, "fpkcheck: {}\n", warning);
  }
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
  const auto problems = load_cases(common);
  if (problems.size() != 1) throw InputError("a study takes one case");
  const compare::OrderStudyOptions options{formulations(formulation_list), orders(order_list)};
  if (common.out) compare::make_writable(*common.out);

  ProgressLine line(common.quiet);
  const auto report = compare::study_orders(command_line, problems[0], options,
                                            [&](const auto& progress) { line.show(progress); });
  line.clear();
  if (common.json) {
    fmt::print("{}\n", compare::json_text(report));
  } else if (!common.quiet) {
    fmt::print("{}", compare::order_table(report, table_width()));
  }
  if (common.out) write(*common.out, report);
  if (!common.quiet && !common.json) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    fmt::print("\n{}{:.1f} s.\n",
               common.out ? fmt::format("Wrote study-order.json, .csv and figures/study-order.png "
                                        "to {} in ",
                                        *common.out)
                          : "Done in ",
               elapsed.count());
  }
  return reached(report) ? kDone : kNotReached;
}

}  // namespace fpkcheck::cli
