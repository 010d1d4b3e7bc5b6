#include "workflows/sweep/report/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace fpkcheck::sweep {
namespace {

using report::TextColumn;

/// The summary of the results of one method over all points.
struct MethodSummary {
  std::map<transform::Status, int> statuses{};
  std::vector<double> l1{};  // of `ok` solutions, the larger of both marginals, sorted
  int references = 0;
  double seconds = 0;
};

MethodSummary summarise_method(const SweepResults& results, std::size_t m) {
  MethodSummary found;
  for (const auto& point : results.points) {
    const MethodResult& one = point.methods[m];
    ++found.statuses[one.status];
    found.seconds += one.seconds;
    const bool is_reference = point.reference == results.plan.methods[m].id();
    found.references += is_reference ? 1 : 0;
    if (one.status != transform::Status::ok || !one.l1 || is_reference) continue;
    found.l1.push_back(std::max(one.l1->y, one.l1->ydot));
  }
  std::ranges::sort(found.l1);
  return found;
}

std::string l1_cell_text(const std::vector<double>& sorted, double quantile) {
  if (sorted.empty()) return report::kAbsent;
  const auto at = static_cast<std::size_t>(quantile * static_cast<double>(sorted.size() - 1) + 0.5);
  return fmt::format("{:.2g}", sorted[at]);
}

std::string other_statuses_cell(const std::map<transform::Status, int>& statuses) {
  std::string text;
  for (const auto& [status, count] : statuses) {
    if (status == transform::Status::ok) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(status));
  }
  return text.empty() ? report::kAbsent : text;
}

}  // namespace

std::vector<TextColumn> method_columns(const SweepResults& results) {
  const Plan& plan = results.plan;
  TextColumn id{"", "solution", true, report::kAlwaysShown},
      ok{"", "ok", false, report::kAlwaysShown}, reference{"", "reference", false, 2},
      median{"L1 of ok", "median", false, 4}, ninetieth_percentile{"L1 of ok", "90 %", false, 3},
      worst{"L1 of ok", "worst", false, 4}, seconds{"", "sec", false, 2},
      others{"", "not ok", true, 1};
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    auto found = summarise_method(results, m);
    id.cells.push_back(plan.methods[m].id());
    ok.cells.push_back(std::to_string(found.statuses[transform::Status::ok]));
    reference.cells.push_back(std::to_string(found.references));
    median.cells.push_back(l1_cell_text(found.l1, 0.5));
    ninetieth_percentile.cells.push_back(l1_cell_text(found.l1, 0.9));
    worst.cells.push_back(l1_cell_text(found.l1, 1));
    seconds.cells.push_back(fmt::format(
        "{:.2g}",
        results.points.empty() ? 0.0 : found.seconds / static_cast<double>(results.points.size())));
    others.cells.push_back(other_statuses_cell(found.statuses));
  }
  return {id, ok, reference, median, ninetieth_percentile, worst, seconds, others};
}

const char* method_columns_legend() {
  return "ok: number of points. L1: distance to the point's reference, the larger of p(y) and "
         "p(y'), over the points where the solution is ok. reference: number of points where the "
         "method is the reference, the most accurate solution of the full problem. sec: mean "
         "wall-clock time per point.";
}

}  // namespace fpkcheck::sweep
