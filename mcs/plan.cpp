#include "mcs/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <thread>

#include "problem/equivalent_linearisation.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kFewestStreams = 8;
constexpr int kMostStreams = 4096;
constexpr int kMostThreads = 1024;
constexpr double kLongestStep = 1;  // the series of order Flight::kOrder loses its accuracy beyond

constexpr int kAutomaticBins = 140;
constexpr double kAutomaticExtent = 7;    // standard deviations
constexpr double kAutomaticTime = 1.2e6;  // slowest decay times: L1 noise of p(y), p(y') about 6e-4
constexpr double kAutomaticStep = 0.8;    // radians: dissipation right to 1e-6
constexpr double kBurnIn = 20;            // slowest decay times: exp(-20) of the start is left
constexpr double kSamplesPerPeriod = 50;  // the bins are narrow: with 25 they are a sixth noisier

void validate_edges(const std::vector<double>& edges, std::string_view key) {
  if (edges.empty()) return;
  const bool finite = std::ranges::all_of(edges, [](double x) { return std::isfinite(x); });
  const bool increasing = std::ranges::is_sorted(edges, std::less_equal<>{});
  if (edges.size() < 2 || !finite || !increasing) {
    throw InputError(
        fmt::format("mcs.{} with {} numbers (edges of bins are two or more finite numbers, each "
                    "larger than the one before); leave them out for automatic bins",
                    key, edges.size()));
  }
}

std::vector<double> evenly_spaced(double from, double to) {
  std::vector<double> edges;
  for (int k = 0; k <= kAutomaticBins; ++k)
    edges.push_back(from + (to - from) * k / kAutomaticBins);
  return edges;
}

BinFinder bins(const std::vector<double>& edges, double from, double to) {
  return BinFinder(edges.empty() ? evenly_spaced(from, to) : edges);
}

int available_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

void validate(const Options& options) {
  if (!std::isfinite(options.time) || options.time < 0) {
    throw InputError(fmt::format("mcs.time = {} (must be a positive number; use 0 for automatic)",
                                 options.time));
  }
  if (options.threads < 0 || options.threads > kMostThreads) {
    throw InputError(fmt::format("mcs.threads = {} (must be 1 to {}; use 0 for one per processor)",
                                 options.threads, kMostThreads));
  }
  if (options.streams < kFewestStreams || options.streams > kMostStreams) {
    throw InputError(fmt::format(
        "mcs.streams = {} (standard errors need {} to {} independent streams; use the default, {})",
        options.streams, kFewestStreams, kMostStreams, Options{}.streams));
  }
  if (!(options.step >= 0 && options.step <= kLongestStep)) {
    throw InputError(fmt::format("mcs.step = {} (must be in (0, {}] radians; use 0 for automatic)",
                                 options.step, kLongestStep));
  }
  validate_edges(options.y_edges, "y_edges");
  validate_edges(options.v_edges, "v_edges");
  if (!options.y_edges.empty() && options.y_edges.front() != 0) {
    throw InputError(fmt::format("mcs.y_edges from {} (y >= 0 begins at the wall; start them at 0)",
                                 options.y_edges.front()));
  }
}

Plan make_plan(const problem::Problem& problem, const Options& options) {
  validate(options);
  const auto linear = problem::equivalent_linearisation(problem);
  const double decay = problem::slowest_decay(linear);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double time = options.time > 0 ? options.time : kAutomaticTime / decay;
  const double interval = 2 * std::numbers::pi / std::sqrt(linear.stiffness) / kSamplesPerPeriod;
  const double samples = std::ceil(time / options.streams / interval);
  const int threads = options.threads > 0 ? options.threads : available_threads();
  return {.streams = options.streams,
          .threads = std::min(threads, options.streams),
          .seed = options.seed,
          .step = options.step > 0 ? options.step : kAutomaticStep,
          .burn_in = kBurnIn / decay,
          .sampling_interval = interval,
          .samples_per_stream = static_cast<std::uint64_t>(samples),
          .displacement_deviation = s1,
          .velocity_deviation = s2,
          .y_bins =
              bins(options.y_edges, 0, problem::static_deflection(problem) + kAutomaticExtent * s1),
          .v_bins = bins(options.v_edges, -kAutomaticExtent * s2, kAutomaticExtent * s2)};
}

}  // namespace fpkcheck::mcs
