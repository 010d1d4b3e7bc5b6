#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/input_error.hpp"
#include "results/csv_field.hpp"
#include "workflows/sweep/result/dimensionless_groups.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {
namespace {

// Number of digits: ten digits exceed the accuracy of every solver, and keep the files small.
std::string number_cell(double number) {
  return std::isfinite(number) ? fmt::format("{:.10g}", number) : std::string();
}

std::string value_cell(const base::Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number)
                           : results::csv_field(std::get<std::string>(value));
}

void append_pair(const std::optional<MarginalL1Pair>& pair, std::vector<std::string>& cells) {
  cells.push_back(pair ? number_cell(pair->y) : "");
  cells.push_back(pair ? number_cell(pair->ydot) : "");
}

// The name of a part of the error budget within a column name: "closure + impact" becomes
// "closure_and_impact".
std::string column_name(std::string part) {
  for (std::size_t at = part.find(" + "); at != part.npos; at = part.find(" + ")) {
    part.replace(at, 3, "_and_");
  }
  std::ranges::replace(part, ' ', '_');
  return part;
}

// The cells are empty if the values of the point are inconsistent.
std::string groups_cells(const Plan& plan, std::size_t point) {
  try {
    const DimensionlessGroups groups = dimensionless_groups(plan.problem_at(point));
    return fmt::format("{:.4g},{:.4g},{:.4g}", groups.impulses_per_decay_time, groups.damping_ratio,
                       groups.cubic_share);
  } catch (const InputError&) {
    return ",,";
  }
}

}  // namespace

std::string csv(const SweepResults& results) {
  const Plan& plan = results.plan;
  const auto parts = results.budget_parts();
  std::vector<std::string> header;
  for (const auto& axis : plan.axes) header.push_back(axis.key);
  for (const char* name : {"solution", "status", "reason"}) header.emplace_back(name);
  for (const auto& moment : transform::kMoments) header.emplace_back(moment.name);
  for (const char* name : {"l1_y", "l1_ydot", "reference", "seconds", "error_y", "error_ydot"}) {
    header.emplace_back(name);
  }
  for (const auto& part : parts) {
    header.push_back("budget_y_" + column_name(part));
    header.push_back("budget_ydot_" + column_name(part));
  }
  for (const char* name : {"impulses_per_decay_time", "damping_ratio", "cubic_share"}) {
    header.emplace_back(name);
  }
  std::string text = fmt::format("{}\n", fmt::join(header, ","));
  for (const auto& point : results.points) {
    std::string keys;
    for (const auto& value : plan.points[point.point]) keys += value_cell(value) + ',';
    const std::string groups = groups_cells(plan, point.point);
    for (std::size_t m = 0; m < point.methods.size(); ++m) {
      const MethodResult& method = point.methods[m];
      std::vector<std::string> cells{plan.methods[m].id(), std::string(name(method.status)),
                                     results::csv_field(method.reason)};
      for (const auto& moment : transform::kMoments) {
        cells.push_back(method.moments ? number_cell((*method.moments).*moment.moment) : "");
      }
      append_pair(method.l1, cells);
      cells.push_back(point.reference);
      cells.push_back(fmt::format("{:.3g}", method.seconds));
      append_pair(method.error, cells);
      for (const auto& part : parts) {
        const auto share = std::ranges::find(method.budget, part, &BudgetContribution::part);
        append_pair(share == method.budget.end() ? std::nullopt : std::optional(share->l1), cells);
      }
      text += fmt::format("{}{},{}\n", keys, fmt::join(cells, ","), groups);
    }
  }
  return text;
}

}  // namespace fpkcheck::sweep
