#include "compare/study/order.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compare/methods.hpp"
#include "compare/summary.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

constexpr double kTailFrom = 1e-5;  // the decade of the reference density that is looked at

const Distances* distances_to_reference(const CaseReport& report, const std::string& id,
                                        Variable variable) {
  for (const auto& comparison : report.comparisons) {
    if (comparison.a == id && comparison.b == kOrderStudyReference &&
        comparison.variable == variable) {
      return &comparison.distances;
    }
  }
  return nullptr;
}

Json tail_of(const Distances& distances) {
  for (const auto& decade : distances.log10_tail) {
    if (std::abs(decade.from / kTailFrom - 1) < 1e-6) return decade.mean_abs;
  }
  return nullptr;
}

Json row_of(const CaseReport& report, const Json& solution) {
  const auto id = solution.at("id").get<std::string>();
  Json row = solution;
  for (const char* left_out : {"options", "moments", "method"}) row.erase(left_out);
  for (const auto variable : {Variable::y, Variable::ydot}) {
    const Distances* distances = distances_to_reference(report, id, variable);
    const auto suffix = std::string(transform::name(variable));
    row["l1_" + suffix] = distances ? Json(distances->l1) : Json();
    row["tail_" + suffix] = distances ? tail_of(*distances) : Json();
  }
  return row;
}

std::string method_list(const OrderStudyOptions& options) {
  std::string list;
  for (const auto& formulation : options.formulations) {
    for (const int order : options.orders) list += fmt::format("epc-{}-n{},", formulation, order);
  }
  return list + kOrderStudyReference;
}

}  // namespace

Json study_orders(const std::string& command, const problem::Problem& problem,
                  const OrderStudyOptions& options, const ProgressListener& listener) {
  const auto reports = run_cases({problem}, select_methods(method_list(options), {}), 1, listener);
  const Json common = summary(command, reports);
  const Json& of_case = common.at("cases").at(0);
  Json reference, rows = Json::array();
  for (const auto& formulation : options.formulations) {
    for (const auto& solution : of_case.at("solutions")) {
      const auto id = solution.at("id").get<std::string>();
      if (!id.starts_with(fmt::format("epc-{}-n", formulation))) continue;
      Json row = row_of(reports[0], solution);
      row["formulation"] = formulation;  // with its variant
      rows.push_back(std::move(row));
    }
  }
  for (const auto& solution : of_case.at("solutions")) {
    if (solution.at("id") != kOrderStudyReference) continue;
    for (const char* key : {"id", "status", "reason", "seconds"}) reference[key] = solution.at(key);
  }
  return with_null_for_non_finite({{"schema", kSummarySchema},
                                   {"program", common.at("program")},
                                   {"study", "order"},
                                   {"name", of_case.at("name")},
                                   {"system", of_case.at("system")},
                                   {"impulse", of_case.at("impulse")},
                                   {"reference", reference},
                                   {"rows", rows}});
}

std::string order_csv(const Json& report) {
  constexpr std::array kNumbers{"iterations", "residual", "condition", "l1_y",
                                "l1_ydot",    "tail_y",   "tail_ydot", "seconds"};
  std::string text = "formulation,order,status";
  for (const char* key : kNumbers) text += fmt::format(",{}", key);
  text += '\n';
  for (const auto& row : report.at("rows")) {
    text += fmt::format("{},{},{}", row.at("formulation").get<std::string>(),
                        row.at("order").get<int>(), row.at("status").get<std::string>());
    for (const char* key : kNumbers) {
      text += ',' + (number(row, key) ? row.at(key).dump() : std::string());
    }
    text += '\n';
  }
  return text;
}

}  // namespace fpkcheck::compare
