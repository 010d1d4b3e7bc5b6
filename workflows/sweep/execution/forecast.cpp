#include "workflows/sweep/execution/forecast.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <queue>
#include <set>

#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "workflows/sweep/execution/solve_point.hpp"

namespace fpkcheck::sweep {
namespace {

// The number of points in the sample: sufficient for the fit, but small in comparison with the
// plan.
constexpr std::size_t kMinSample = 24, kMaxSample = 64;
constexpr double kSampleFraction = 0.06;

std::size_t sample_size(std::size_t points) {
  return std::clamp(static_cast<std::size_t>(kSampleFraction * static_cast<double>(points)),
                    kMinSample, kMaxSample);
}

// The relative standard error of the predicted sum, by leave-one-out cross-validation: the root of
// the sum of squares of the prediction errors, divided by the sum of the seconds.
double relative_standard_error(const Plan& plan,
                               const std::vector<CostModel::Measurement>& sample) {
  if (sample.size() < 3) return 1;
  if (sample.size() >= plan.points.size()) return 0;
  double squares = 0, sum = 0;
  for (std::size_t omitted = 0; omitted < sample.size(); ++omitted) {
    auto others = sample;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(omitted));
    const double residual =
        sample[omitted].seconds - CostModel(plan, others).expected_seconds(sample[omitted].point);
    squares += residual * residual;
    sum += sample[omitted].seconds;
  }
  return sum > 0 ? std::sqrt(squares) / sum : 0;
}

}  // namespace

double makespan(std::span<const double> seconds, std::size_t workers, DispatchRule dispatch) {
  if (dispatch == DispatchRule::shards) {
    std::vector<double> each(workers, 0);
    for (std::size_t p = 0; p < seconds.size(); ++p) each[p % workers] += seconds[p];
    return std::ranges::max(each);
  }
  std::vector<double> order(seconds.begin(), seconds.end());
  if (dispatch == DispatchRule::longest_first) std::ranges::sort(order, std::ranges::greater{});
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (std::size_t w = 0; w < workers; ++w) free_at.push(0);
  double last = 0;
  for (const double one : order) {
    const double end = free_at.top() + one;
    free_at.pop();
    free_at.push(end);
    last = std::max(last, end);
  }
  return last;
}

Forecast forecast(const Plan& plan, const std::vector<PointResult>& solved, int threads) {
  Forecast found;
  std::set<std::size_t> known;
  for (const auto& one : solved) {
    known.insert(one.point);
    found.sample.push_back({one.point, one.seconds});
  }
  std::vector<std::size_t> unknown;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (!known.contains(p)) unknown.push_back(p);
  }
  const std::size_t sample_count = sample_size(plan.points.size());
  const auto chosen =
      evenly_spread_sample(unknown, sample_count - std::min(sample_count, known.size()));
  std::mutex mutex;
  base::parallel_for(chosen.size(), threads, [&](std::size_t k) {
    if (base::stop_requested()) return;
    const double seconds = solve_point(plan, chosen[k]).result.seconds;
    const std::lock_guard lock(mutex);
    found.sample.push_back({chosen[k], seconds});
  });
  found.seconds = CostModel(plan, found.sample).all_expected_seconds();
  found.uncertainty = relative_standard_error(plan, found.sample);
  rusage usage{};
  if (!chosen.empty() && getrusage(RUSAGE_SELF, &usage) == 0) {
    constexpr double kKilobytesToMegabytes = 1.0 / 1024;
    found.megabytes = static_cast<double>(usage.ru_maxrss) * kKilobytesToMegabytes;
  }
  return found;
}

}  // namespace fpkcheck::sweep
