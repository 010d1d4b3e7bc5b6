#include "mcs/simulate.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>
#include <utility>

#include "mcs/plan.hpp"
#include "mcs/stream.hpp"
#include "mcs/stream_weights.hpp"
#include "problem/energy_balance.hpp"

namespace fpkcheck::mcs {
namespace {

using Records = std::vector<StreamRecord>;

/// All streams of the plan, in their order. Threads take whole streams, so that nothing depends on
/// how many there are.
Records run_streams(const problem::Problem& problem, const Plan& plan,
                    const std::function<void(double)>& progress) {
  std::vector<std::optional<StreamRecord>> slots(plan.streams);
  std::atomic<int> next = 0;
  std::mutex mutex;  // guards the two below
  int done = 0;
  std::exception_ptr failure;

  const auto work = [&] {
    for (int s = next++; s < plan.streams; s = next++) {
      try {
        slots[s] = run_stream(problem, plan, static_cast<std::uint32_t>(s));
        const std::lock_guard lock(mutex);
        ++done;
        if (progress && !failure) progress(static_cast<double>(done) / plan.streams);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = plan.streams;  // nobody begins another stream
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int t = 1; t < plan.threads; ++t) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);

  Records records;
  for (auto& slot : slots) records.push_back(std::move(*slot));
  return records;
}

/// One number per stream.
template <class Of>
std::vector<double> each(const Records& records, Of of) {
  std::vector<double> values;
  for (const StreamRecord& record : records) values.push_back(of(record));
  return values;
}

/// A marginal with 95 % intervals from the streams' own histograms.
/// @param counts the streams' counts of one variable, with the two outer bins
/// @param[out] sampling_l1 the sum over bins of sqrt(2/pi) * standard error * width
transform::Marginal estimate_marginal(const std::vector<std::vector<std::uint64_t>>& counts,
                                      const std::vector<double>& edges, const Plan& plan,
                                      const StreamWeights& weights, double effective_samples,
                                      double& sampling_l1) {
  transform::Marginal marginal{.edges = edges, .density = {}, .lower = {}, .upper = {}};
  sampling_l1 = 0;
  std::vector<double> densities(counts.size());
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double width = edges[b + 1] - edges[b];
    const double unit = 1 / (static_cast<double>(plan.samples_per_stream) * width);
    for (std::size_t s = 0; s < counts.size(); ++s) {
      densities[s] = static_cast<double>(counts[s][b + 1]) * unit;
    }
    const auto [density, error] = weights.estimate(densities);
    const double half_width = weights.interval_factor() * error;
    marginal.density.push_back(std::max(density, 0.0));  // see joint_density
    marginal.lower.push_back(std::max(density - half_width, 0.0));
    // Nothing seen in n independent draws: less than 3/n with 95 % confidence ("rule of three").
    marginal.upper.push_back(error > 0 ? density + half_width : 3 / (effective_samples * width));
    sampling_l1 += std::sqrt(2 / std::numbers::pi) * error * width;
  }
  return marginal;
}

transform::GridDensity joint_density(const Records& records, const Plan& plan,
                                     const StreamWeights& weights) {
  transform::GridDensity density{plan.y_bins.edges(), plan.v_bins.edges(), {}};
  density.averages.resize(density.ny() * density.nv());
  for (std::size_t s = 0; s < records.size(); ++s) {
    const double per_sample = weights[s] / static_cast<double>(plan.samples_per_stream);
    for (std::size_t i = 0; i < density.ny(); ++i) {
      const double per_row = per_sample / (density.y_edges[i + 1] - density.y_edges[i]);
      for (std::size_t j = 0; j < density.nv(); ++j) {
        const double per_cell = per_row / (density.v_edges[j + 1] - density.v_edges[j]);
        density.averages[i * density.nv() + j] +=
            per_cell * static_cast<double>(records[s].histogram.count(i + 1, j + 1));
      }
    }
  }
  // A cell that only streams of negative weight have visited (StreamWeights: short runs, far
  // tails).
  for (double& average : density.averages) average = std::max(average, 0.0);
  return density;
}

/// Plain variance of an estimate over the one with weights.
double variance_reduction(const Estimate& plain, const Estimate& weighted) {
  const double ratio = plain.standard_error / weighted.standard_error;
  return ratio * ratio;
}

}  // namespace

Result simulate(const problem::Problem& problem, const Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Plan plan = make_plan(problem, options);
  const Records records = run_streams(problem, plan, options.progress);
  const StreamWeights weights(each(records, [](const auto& r) { return r.excess_power; }));

  Result result;
  auto& [solution, summary] = result;
  solution.id = solution.method = "mcs";
  solution.equation = "kf";
  solution.impact = problem::Impact::exact;
  solution.status = transform::Status::ok;

  for (const auto member :
       {&transform::Moments::y1, &transform::Moments::y2, &transform::Moments::y4,
        &transform::Moments::v1, &transform::Moments::v2, &transform::Moments::v4}) {
    const auto moment =
        weights.estimate(each(records, [&](const auto& r) { return r.moments.*member; }));
    solution.moments.*member = moment.mean;
    summary.standard_errors.moments.*member = moment.standard_error;
  }
  // The residual is linear in the averages: its own average over the streams.
  const auto residual = weights.estimate(each(records, [&](const auto& r) {
    return problem::energy_residual(problem, solution.impact,
                                    {.mean_velocity = r.moments.v1,
                                     .mean_square_velocity = r.moments.v2,
                                     .impact_energy_flux = r.impact_energy_flux});
  }));
  solution.energy_residual = residual.mean;
  summary.standard_errors.energy_residual = residual.standard_error;

  const auto plain_y2 = plain_estimate(each(records, [](const auto& r) { return r.moments.y2; }));
  const auto plain_v2 = plain_estimate(each(records, [](const auto& r) { return r.moments.v2; }));
  const auto& [y1, y2, y4, v1, v2, v4] = solution.moments;
  const auto& errors = summary.standard_errors.moments;
  summary.effective_samples = (v4 - v2 * v2) / (plain_v2.standard_error * plain_v2.standard_error);
  summary.variance_reduction_y2 = variance_reduction(plain_y2, {y2, errors.y2});
  summary.variance_reduction_v2 = variance_reduction(plain_v2, {v2, errors.v2});

  std::vector<std::vector<std::uint64_t>> y_counts, v_counts;
  for (const StreamRecord& record : records) {
    y_counts.push_back(record.histogram.row_counts());
    v_counts.push_back(record.histogram.column_counts());
  }
  solution.estimated_marginals.emplace_back(
      transform::Variable::y, estimate_marginal(y_counts, plan.y_bins.edges(), plan, weights,
                                                summary.effective_samples, summary.sampling_l1_y));
  solution.estimated_marginals.emplace_back(
      transform::Variable::ydot,
      estimate_marginal(v_counts, plan.v_bins.edges(), plan, weights, summary.effective_samples,
                        summary.sampling_l1_ydot));
  const transform::GridDensity density = joint_density(records, plan, weights);
  solution.mass = transform::mass(density);
  solution.density = density;

  summary.time = plan.stream_time() * plan.streams;
  summary.samples = plan.samples_per_stream * static_cast<std::uint64_t>(plan.streams);
  summary.sampling_interval = plan.sampling_interval;
  summary.outside = std::max(0.0, 1 - solution.mass);
  summary.seed = plan.seed;
  summary.threads = plan.threads;
  summary.streams = plan.streams;
  summary.step = plan.step;
  summary.burn_in = plan.burn_in;
  std::uint64_t impacts = 0;
  for (const StreamRecord& record : records) {
    impacts += record.impacts;
    summary.impulses += record.impulses;
  }
  summary.impact_rate = static_cast<double>(impacts) / summary.time;
  solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace fpkcheck::mcs
