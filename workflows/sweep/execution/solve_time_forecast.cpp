#include "workflows/sweep/execution/solve_time_forecast.hpp"

#include <sys/resource.h>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <queue>
#include <set>

#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "workflows/sweep/execution/solve_point.hpp"

namespace fpkcheck::sweep {
namespace {

constexpr double kMinSeconds = 1e-6;  // lower bound of a time, whose logarithm must exist

/// Values of the basis functions of a quadratic polynomial at a sweep point.
class QuadraticBasis {
 public:
  explicit QuadraticBasis(const SweepPlan& plan) : plan_(plan) {
    for (std::size_t a = 0; a < plan.axes.size(); ++a) {
      Range range{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
      for (const auto& point : plan.points) {
        if (const auto* number = std::get_if<double>(&point[a])) {
          const double at = scaled(a, *number);
          range = {std::min(range.least, at), std::max(range.greatest, at)};
        }
      }
      ranges_.push_back(range);
    }
  }

  Eigen::VectorXd at(std::size_t point) const {
    std::vector<double> linear;
    std::vector<double> terms{1};
    for (std::size_t a = 0; a < plan_.axes.size(); ++a) {
      const auto& value = plan_.points[point][a];
      if (const auto* number = std::get_if<double>(&value)) {
        const auto [least, greatest] = ranges_[a];
        linear.push_back(
            greatest > least ? 2 * (scaled(a, *number) - least) / (greatest - least) - 1 : 0.0);
      } else {
        // Each value of a categorical key has an indicator function as basis function.
        for (const auto& word : plan_.axes[a].values) terms.push_back(word == value ? 1 : 0);
      }
    }
    for (std::size_t i = 0; i < linear.size(); ++i) {
      terms.push_back(linear[i]);
      for (std::size_t j = i; j < linear.size(); ++j) terms.push_back(linear[i] * linear[j]);
    }
    return Eigen::Map<Eigen::VectorXd>(terms.data(), static_cast<Eigen::Index>(terms.size()));
  }

 private:
  struct Range {
    double least, greatest;
  };

  double scaled(std::size_t axis, double value) const {
    return plan_.axes[axis].spacing == SweepAxisSpacing::logarithmic ? std::log(value) : value;
  }

  const SweepPlan& plan_;
  std::vector<Range> ranges_;
};

// Limits of the number of points in the sample, which must suffice for the fit of the solve time
// model.
constexpr std::size_t kMinSample = 24, kMaxSample = 64;
constexpr double kSampleFraction = 0.06;

std::size_t forecast_sample_size(std::size_t points) {
  return std::clamp(static_cast<std::size_t>(kSampleFraction * static_cast<double>(points)),
                    kMinSample, kMaxSample);
}

// Leave-one-out cross-validation gives the relative standard error: the root of the sum of squared
// prediction errors, divided by the sum of the measured seconds.
double relative_standard_error(const SweepPlan& plan,
                               const std::vector<SolveTimeModel::Measurement>& sample) {
  if (sample.size() < 3) return 1;
  if (sample.size() >= plan.points.size()) return 0;
  double squares = 0, sum = 0;
  for (std::size_t omitted = 0; omitted < sample.size(); ++omitted) {
    auto others = sample;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(omitted));
    const double residual = sample[omitted].seconds -
                            SolveTimeModel(plan, others).expected_seconds(sample[omitted].point);
    squares += residual * residual;
    sum += sample[omitted].seconds;
  }
  return sum > 0 ? std::sqrt(squares) / sum : 0;
}

}  // namespace

SolveTimeModel::SolveTimeModel(const SweepPlan& plan, std::span<const Measurement> measured)
    : expected_(plan.points.size(), 1.0) {
  if (measured.empty()) return;
  const QuadraticBasis terms(plan);
  const Eigen::Index unknowns = terms.at(0).size();
  // A ridge regression determines all coefficients even if few points are measured.
  constexpr double kRidge = 0.03;
  Eigen::MatrixXd normal = kRidge * Eigen::MatrixXd::Identity(unknowns, unknowns);
  normal(0, 0) = 0;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  for (const auto& [point, seconds] : measured) {
    const Eigen::VectorXd row = terms.at(point);
    normal += row * row.transpose();
    right += row * std::log(std::max(seconds, kMinSeconds));
  }
  const Eigen::VectorXd coefficients = normal.ldlt().solve(right);
  // The exponential of the fitted mean logarithm underestimates the mean solve time, and is
  // therefore scaled to the measured times.
  double sum = 0, fitted = 0;
  for (const auto& [point, seconds] : measured) {
    sum += seconds;
    fitted += std::exp(coefficients.dot(terms.at(point)));
  }
  for (std::size_t p = 0; p < expected_.size(); ++p) {
    expected_[p] = sum / fitted * std::exp(coefficients.dot(terms.at(p)));
  }
  for (const auto& [point, seconds] : measured) expected_[point] = seconds;
}

std::vector<std::size_t> evenly_spread_sample(const std::vector<std::size_t>& candidates,
                                              std::size_t count) {
  // Steps of the golden ratio through the list of points avoid resonance with the periods of a
  // Cartesian product of axes.
  constexpr double kGolden = 0.6180339887498949;
  std::vector<std::size_t> chosen;
  const std::size_t most = std::min(count, candidates.size());
  for (std::size_t k = 0; chosen.size() < most && k < 4 * candidates.size(); ++k) {
    const double fraction = std::fmod(0.5 + static_cast<double>(k) * kGolden, 1.0);
    const auto at =
        candidates[static_cast<std::size_t>(fraction * static_cast<double>(candidates.size()))];
    if (std::ranges::find(chosen, at) == chosen.end()) chosen.push_back(at);
  }
  return chosen;
}

double parallel_wall_clock_time(std::span<const double> seconds, std::size_t workers,
                                SweepPointDispatchRule dispatch) {
  if (dispatch == SweepPointDispatchRule::shards) {
    std::vector<double> each(workers, 0);
    for (std::size_t p = 0; p < seconds.size(); ++p) each[p % workers] += seconds[p];
    return std::ranges::max(each);
  }
  std::vector<double> order(seconds.begin(), seconds.end());
  if (dispatch == SweepPointDispatchRule::longest_first)
    std::ranges::sort(order, std::ranges::greater{});
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

SolveTimeForecast forecast_solve_times(const SweepPlan& plan,
                                       const std::vector<SweepPointResult>& solved, int threads) {
  SolveTimeForecast found;
  std::set<std::size_t> known;
  for (const auto& one : solved) {
    known.insert(one.point);
    found.sample.push_back({one.point, one.seconds});
  }
  std::vector<std::size_t> unknown;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (!known.contains(p)) unknown.push_back(p);
  }
  const std::size_t sample_count = forecast_sample_size(plan.points.size());
  const auto chosen =
      evenly_spread_sample(unknown, sample_count - std::min(sample_count, known.size()));
  std::mutex mutex;
  base::parallel_for(chosen.size(), threads, [&](std::size_t k) {
    if (base::stop_requested()) return;
    const double seconds = solve_sweep_point(plan, chosen[k]).result.seconds;
    const std::lock_guard lock(mutex);
    found.sample.push_back({chosen[k], seconds});
  });
  found.seconds = SolveTimeModel(plan, found.sample).all_expected_seconds();
  found.uncertainty = relative_standard_error(plan, found.sample);
  rusage usage{};
  if (!chosen.empty() && getrusage(RUSAGE_SELF, &usage) == 0) {
    constexpr double kKilobytesToMegabytes = 1.0 / 1024;
    found.megabytes = static_cast<double>(usage.ru_maxrss) * kKilobytesToMegabytes;
  }
  return found;
}

}  // namespace fpkcheck::sweep
