#include "workflows/sweep/report/forecast_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "report/text/columns.hpp"
#include "report/text/wrap_text.hpp"

namespace fpkcheck::sweep {

std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 10 * kMinute) return fmt::format("{:.1f} min", seconds / kMinute);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

std::string forecast_text(const Plan& plan, const Forecast& forecast, std::size_t threads,
                          const std::vector<int>& ranks, const report::TextFormat& format) {
  const double all = std::accumulate(forecast.seconds.begin(), forecast.seconds.end(), 0.0);
  constexpr double kTwoStandardErrors = 200;  // in per cent
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
                  duration_text(makespan(forecast.seconds, threads, DispatchRule::longest_first)),
                  forecast.megabytes > 0 ? fmt::format(", {:.0f} MB", forecast.megabytes) : ""),
      format.width);
  if (ranks.empty()) return text;
  using report::TextColumn;
  TextColumn count{"", "ranks", false, report::kAlwaysShown},
      longest{"", "longest first", false, report::kAlwaysShown},
      busy{"", "busy", false, report::kAlwaysShown},
      in_order{"", "in order", false, report::kAlwaysShown},
      shards{"", "shards", false, report::kAlwaysShown},
      memory{"", "GB", false, report::kAlwaysShown};
  for (const int number : ranks) {
    const auto workers = static_cast<std::size_t>(number);
    const double best = makespan(forecast.seconds, workers, DispatchRule::longest_first);
    count.cells.push_back(std::to_string(number));
    longest.cells.push_back(duration_text(best));
    busy.cells.push_back(fmt::format("{:.0f} %", 100 * all / (best * number)));
    in_order.cells.push_back(
        duration_text(makespan(forecast.seconds, workers, DispatchRule::in_order)));
    shards.cells.push_back(
        duration_text(makespan(forecast.seconds, workers, DispatchRule::shards)));
    memory.cells.push_back(forecast.megabytes > 0
                               ? fmt::format("{:.1f}", forecast.megabytes * number / 1024)
                               : report::kAbsent);
  }
  return text + '\n' +
         report::table_rows_text({count, longest, busy, in_order, shards, memory}, format) + '\n' +
         report::wrap_text(
             "ranks: processes of one thread. longest first: the order of mpirun, the longest "
             "expected point first; busy: fraction of the time in which its ranks solve. in order: "
             "each point to the next free rank. shards: every N-th point to the same rank, in "
             "advance. GB: upper bound for all ranks together.",
             format.width);
}

}  // namespace fpkcheck::sweep
