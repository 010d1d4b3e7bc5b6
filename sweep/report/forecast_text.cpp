#include "sweep/report/forecast_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "report/text/wrapped.hpp"

namespace fpkcheck::sweep {

std::string time_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

std::string forecast_text(const Plan& plan, const Forecast& forecast, std::size_t threads,
                          std::size_t ranks, std::size_t width) {
  const double all = std::accumulate(forecast.seconds.begin(), forecast.seconds.end(), 0.0);
  const auto time = [&](std::size_t workers, Dispatch dispatch) {
    return time_text(makespan(forecast.seconds, workers, dispatch));
  };
  constexpr double kTwoStandardErrors = 200;  // in per cent
  std::string text = fmt::format(
      "{} points, {} methods: {} by one thread (+-{:.0f} %), the longest point {}; on this machine "
      "with {} thread{} {}, {:.0f} MB. Told from {} points that were solved; nothing was written.\n",
      plan.points.size(), plan.methods.size(), time_text(all),
      std::max(1.0, kTwoStandardErrors * forecast.uncertainty),
      time_text(std::ranges::max(forecast.seconds)), threads, threads == 1 ? "" : "s",
      time(threads, Dispatch::longest_first), forecast.megabytes, forecast.sample.size());
  text = report::wrapped(text, width);
  if (ranks > 1) {
    const double megabytes_a_thread = forecast.megabytes;
    text += report::wrapped(
        fmt::format(
            "{0} ranks of one thread: {1} by handing out the longest expected first, {2} in "
            "order, {3} by shards; at most {4:.1f} GB in all.",
            ranks, time(ranks, Dispatch::longest_first), time(ranks, Dispatch::in_order),
            time(ranks, Dispatch::shards), static_cast<double>(ranks) * megabytes_a_thread / 1024),
        width);
  }
  return text;
}

}  // namespace fpkcheck::sweep
