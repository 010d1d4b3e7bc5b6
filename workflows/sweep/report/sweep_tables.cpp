#include "workflows/sweep/report/sweep_tables.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "report/text/text_layout.hpp"

namespace fpkcheck::sweep {
namespace {

using report::TextTableColumn;

struct SweepMethodSummary {
  std::map<transform::Status, int> statuses{};
  std::vector<double> l1{};  // larger L1 distance of p(y) and p(y') of each `ok` solution, sorted
  int references = 0;
  double seconds = 0;
};

SweepMethodSummary summarise_method(const SweepResults& results, std::size_t m) {
  SweepMethodSummary found;
  for (const auto& point : results.points) {
    const SweepMethodResult& one = point.methods[m];
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

std::string l1_distance_cell_text(const std::vector<double>& sorted, double quantile) {
  if (sorted.empty()) return report::kMissingCell;
  const auto at = static_cast<std::size_t>(quantile * static_cast<double>(sorted.size() - 1) + 0.5);
  return fmt::format("{:.2g}", sorted[at]);
}

std::string status_counts_cell(const std::map<transform::Status, int>& statuses) {
  std::string text;
  for (const auto& [status, count] : statuses) {
    if (status == transform::Status::ok) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(status));
  }
  return text.empty() ? report::kMissingCell : text;
}

}  // namespace

std::vector<TextTableColumn> method_table_columns(const SweepResults& results) {
  const SweepPlan& plan = results.plan;
  std::vector<TextTableColumn> columns{{"", "solution", true, report::kAlwaysShown},
                                       {"", "ok", false, report::kAlwaysShown},
                                       {"", "reference", false, 2},
                                       {"L1 of ok", "median", false, 4},
                                       {"L1 of ok", "90 %", false, 3},
                                       {"L1 of ok", "worst", false, 4},
                                       {"", "sec", false, 2},
                                       {"", "not ok", true, 1}};
  const auto points = static_cast<double>(std::max<std::size_t>(results.points.size(), 1));
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    auto found = summarise_method(results, m);
    report::add_table_row(
        columns,
        {plan.methods[m].id(), std::to_string(found.statuses[transform::Status::ok]),
         std::to_string(found.references), l1_distance_cell_text(found.l1, 0.5),
         l1_distance_cell_text(found.l1, 0.9), l1_distance_cell_text(found.l1, 1),
         fmt::format("{:.2g}", found.seconds / points), status_counts_cell(found.statuses)});
  }
  return columns;
}

const char* method_table_legend() {
  return "ok: number of points. L1: distance to the point's reference, the larger of p(y) and "
         "p(y'), over the points where the solution is ok. reference: number of points where the "
         "method is the reference, the most accurate solution of the full problem. sec: mean "
         "wall-clock time per point.";
}

std::string sweep_table_text(const SweepResults& results,
                             const report::TerminalTextFormat& format) {
  const SweepPlan& plan = results.plan;
  std::string text = fmt::format("{} points of {}", results.points.size(), plan.base.name);
  for (const auto& axis : plan.axes) text += ", " + axis.axis_definition_text();
  text = report::wrap_text(text, format.width, 2) + '\n';
  text += report::format_text_table(method_table_columns(results), format);
  return text + '\n' + report::wrap_text(method_table_legend(), format.width);
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 10 * kMinute) return fmt::format("{:.1f} min", seconds / kMinute);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

std::string solve_time_forecast_text(const SweepPlan& plan, const SolveTimeForecast& forecast,
                                     std::size_t threads, const std::vector<int>& ranks,
                                     const report::TerminalTextFormat& format) {
  const double all = std::accumulate(forecast.seconds.begin(), forecast.seconds.end(), 0.0);
  constexpr double kTwoStandardErrors = 200;
  const bool measured = forecast.sample.size() >= plan.points.size();
  std::string text = report::wrap_text(
      fmt::format("{} points, {} method{}: {} by one thread ({}), the longest point {}. On this "
                  "machine, {} thread{}: {}{}. Nothing was written.",
                  plan.points.size(), plan.methods.size(), plan.methods.size() == 1 ? "" : "s",
                  duration_text(all),
                  measured ? "measured"
                           : fmt::format("+-{:.0f} %, predicted from {} points",
                                         std::max(1.0, kTwoStandardErrors * forecast.uncertainty),
                                         forecast.sample.size()),
                  duration_text(std::ranges::max(forecast.seconds)), threads,
                  threads == 1 ? "" : "s",
                  duration_text(parallel_wall_clock_time(forecast.seconds, threads,
                                                         SweepPointDispatchRule::longest_first)),
                  forecast.megabytes > 0 ? fmt::format(", {:.0f} MB", forecast.megabytes) : ""),
      format.width);
  if (ranks.empty()) return text;
  constexpr int kAlways = report::kAlwaysShown;
  std::vector<TextTableColumn> columns{
      {"", "ranks", false, kAlways},  {"", "longest first", false, kAlways},
      {"", "busy", false, kAlways},   {"", "in order", false, kAlways},
      {"", "shards", false, kAlways}, {"", "GB", false, kAlways}};
  for (const int number : ranks) {
    const auto time = [&](SweepPointDispatchRule rule) {
      return parallel_wall_clock_time(forecast.seconds, static_cast<std::size_t>(number), rule);
    };
    const double best = time(SweepPointDispatchRule::longest_first);
    report::add_table_row(
        columns, {std::to_string(number), duration_text(best),
                  fmt::format("{:.0f} %", 100 * all / (best * number)),
                  duration_text(time(SweepPointDispatchRule::in_order)),
                  duration_text(time(SweepPointDispatchRule::shards)),
                  forecast.megabytes > 0 ? fmt::format("{:.1f}", forecast.megabytes * number / 1024)
                                         : report::kMissingCell});
  }
  return text + '\n' + report::format_text_table(std::move(columns), format) + '\n' +
         report::wrap_text(
             "ranks: processes of one thread. longest first: the order of mpirun, the longest "
             "expected point first; busy: fraction of the time in which its ranks solve. in order: "
             "each point to the next free rank. shards: every N-th point to the same rank, in "
             "advance. GB: upper bound for all ranks together.",
             format.width);
}

}  // namespace fpkcheck::sweep
