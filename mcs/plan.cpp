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
constexpr double kLongestStep =
    1.2;  // the series of order Flight::kOrder loses its accuracy beyond
constexpr double kLongestWhiteStep = 0.5;
constexpr double kShortestStep = 1e-4;
constexpr double kMostSamples = 1e15;  // of a stream

constexpr int kAutomaticBins = 140;
constexpr double kAutomaticExtent = 7;    // standard deviations
constexpr double kAutomaticTime = 1.6e6;  // slowest decay times: L1 noise of p(y), p(y') about 6e-4
constexpr double kTailsShare = 1.0 / 32;  // of it: the branches take several times as long
constexpr double kAutomaticStep = 0.9;    // radians: errors below those of RK4 with step 0.05
constexpr double kAutomaticWhiteStep = 0.05;
constexpr double kBurnIn = 20;            // slowest decay times: exp(-20) of the start is left
constexpr double kSamplesPerPeriod = 25;  // with 50 the bins are a seventh less noisy, and dearer
// Progress and interruptions come by rounds: a fortieth of the automatic time, a tenth of a second
// or so, or an eighth of what was asked for if that is less.
constexpr double kAutomaticRounds = 40;
constexpr double kFewestRounds = 8;
constexpr double kMostEvents = 2e7;          // impulses and flights of a round, in all streams
constexpr double kMostAutomaticTimes = 1e4;  // where samples or an error are asked for

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
  const auto validate_step = [](double step, double longest, std::string_view key) {
    if (step == 0 || (step >= kShortestStep && step <= longest)) return;
    throw InputError(fmt::format("mcs.{} = {} (must be {} to {} radians; use 0 for automatic)", key,
                                 step, kShortestStep, longest));
  };
  validate_step(options.step, kLongestStep, "step");
  validate_step(options.white_step, kLongestWhiteStep, "white_step");
  if (!std::isfinite(options.samples) || options.samples < 0) {
    throw InputError(
        fmt::format("mcs.samples = {} (must be a positive number; use 0 for as many "
                    "as the time gives)",
                    options.samples));
  }
  if (!(options.target_error >= 0 && options.target_error < 1)) {
    throw InputError(
        fmt::format("mcs.target_error = {} (must be above 0 and below 1; use 0 for "
                    "what the time gives)",
                    options.target_error));
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
  const double automatic = kAutomaticTime * (options.tails ? kTailsShare : 1) / decay;
  const bool open_ended = options.samples > 0 || options.target_error > 0;
  const double time =
      options.time > 0 ? options.time : automatic * (open_ended ? kMostAutomaticTimes : 1);
  const double interval = 2 * std::numbers::pi / std::sqrt(linear.stiffness) / kSamplesPerPeriod;
  const Excitation excitation =
      options.equation == Equation::white
          ? white_excitation(problem.impulses,
                             (options.white_step > 0 ? options.white_step : kAutomaticWhiteStep) /
                                 std::sqrt(linear.stiffness))
          : poisson_excitation(problem.impulses);
  const double step = options.step > 0 ? options.step : kAutomaticStep;
  const double events = 1 / excitation.interval + std::sqrt(linear.stiffness) / step;
  const double round_time =
      std::min({automatic / kAutomaticRounds, time / kFewestRounds, kMostEvents / events});
  // Of a length that does not depend on the time asked for, unless that is short: so a longer
  // simulation can go on from the checkpoint of a shorter one.
  const double samples = std::ceil(round_time / options.streams / interval * (1 - 1e-12));
  const double rounds = std::ceil(time / (samples * options.streams * interval) * (1 - 1e-12));
  if (!(samples >= 1 && samples * rounds <= kMostSamples)) {
    throw InputError(fmt::format(
        "mcs.time = {} (each of {} streams would take {:.0e} samples; at most {:.0e}) use less",
        time, options.streams, samples * rounds, kMostSamples));
  }
  const int threads = options.threads > 0 ? options.threads : available_threads();
  return {.streams = options.streams,
          .threads = std::min(threads, options.streams),
          .seed = options.seed,
          .step = step,
          .burn_in = kBurnIn / decay,
          .sampling_interval = interval,
          .samples_per_round = static_cast<std::uint64_t>(samples),
          .rounds = static_cast<std::uint64_t>(rounds),
          .displacement_deviation = s1,
          .velocity_deviation = s2,
          .excitation = excitation,
          .y_bins =
              bins(options.y_edges, 0, problem::static_deflection(problem) + kAutomaticExtent * s1),
          .v_bins = bins(options.v_edges, -kAutomaticExtent * s2, kAutomaticExtent * s2)};
}

}  // namespace fpkcheck::mcs
