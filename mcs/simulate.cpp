#include "mcs/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "mcs/density_estimate.hpp"
#include "mcs/plan.hpp"
#include "mcs/run_streams.hpp"
#include "mcs/stream_weights.hpp"
#include "problem/energy_balance.hpp"

namespace fpkcheck::mcs {
namespace {

using Records = std::vector<StreamRecord>;

void estimate_moments(const Records& records, const StreamWeights& weights, Result& result) {
  using transform::Moments;
  for (const auto member :
       {&Moments::y1, &Moments::y2, &Moments::y4, &Moments::v1, &Moments::v2, &Moments::v4}) {
    const auto moment =
        weights.estimate(each(records, [&](const auto& r) { return r.moments.*member; }));
    result.solution.moments.*member = moment.mean;
    result.summary.standard_errors.moments.*member = moment.standard_error;
  }
}

void estimate_energy_residual(const problem::Problem& problem, const Records& records,
                              const StreamWeights& weights, Result& result) {
  // Linear in the averages: the average of the streams' own residuals.
  const auto residual = weights.estimate(each(records, [&](const auto& r) {
    return problem::energy_residual(problem, problem::Impact::exact,
                                    {.mean_velocity = r.moments.v1,
                                     .mean_square_velocity = r.moments.v2,
                                     .impact_energy_flux = r.impact_energy_flux});
  }));
  result.solution.energy_residual = residual.mean;
  result.summary.standard_errors.energy_residual = residual.standard_error;
}

/// Whether the impulses followed their law, before the weights set it right.
void estimate_excess_power(const problem::Problem& problem, const Records& records,
                           Summary& summary) {
  const double input = problem.impulses.intensity() / 2;
  const auto excess =
      plain_estimate(each(records, [&](const auto& r) { return r.excess_power / input; }));
  summary.excess_power = excess.mean;
  summary.excess_power_error = excess.standard_error;
}

/// What the samples are worth without the weights, and what the weights add.
void estimate_efficiency(const Records& records, Result& result) {
  const auto plain_variance = [&](auto member) {
    const double error = plain_estimate(each(records, [&](const auto& r) {
                           return r.moments.*member;
                         })).standard_error;
    return error * error;
  };
  const auto variance = [&](auto member) {
    const double error = result.summary.standard_errors.moments.*member;
    return error * error;
  };
  constexpr auto y2 = &transform::Moments::y2, v2 = &transform::Moments::v2;
  const auto& m = result.solution.moments;
  result.summary.effective_samples = (m.v4 - m.v2 * m.v2) / plain_variance(v2);
  result.summary.variance_reduction_y2 = plain_variance(y2) / variance(y2);
  result.summary.variance_reduction_v2 = plain_variance(v2) / variance(v2);
}

void estimate_densities(const Records& records, const Plan& plan, const StreamWeights& weights,
                        Result& result) {
  auto& [solution, summary] = result;
  const auto marginal = [&](transform::Variable variable) {
    auto estimate = estimate_marginal(records, plan, weights, variable, summary.effective_samples);
    solution.estimated_marginals.emplace_back(variable, std::move(estimate.marginal));
    return estimate.sampling_l1;
  };
  summary.sampling_l1_y = marginal(transform::Variable::y);
  summary.sampling_l1_ydot = marginal(transform::Variable::ydot);
  auto joint = estimate_joint_density(records, plan, weights);
  solution.mass = transform::mass(joint);
  solution.density = std::move(joint);
  summary.outside = std::max(0.0, 1 - solution.mass);
}

void describe(const Records& records, const Plan& plan, Summary& summary) {
  summary.time = plan.stream_time() * plan.streams;
  summary.samples = plan.samples_per_stream * static_cast<std::uint64_t>(plan.streams);
  summary.sampling_interval = plan.sampling_interval;
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
}

void judge(transform::Solution& solution) {
  const transform::Moments& m = solution.moments;
  const bool finite = std::isfinite(m.y1 + m.y2 + m.y4 + m.v1 + m.v2 + m.v4);
  solution.status = transform::Status::ok;
  if (!finite || !(solution.mass > 0)) {
    solution.status = transform::Status::failed;
    solution.reason =
        "the trajectories left the range of numbers, or the histogram altogether (is the problem "
        "scaled sensibly?)";
  }
}

}  // namespace

Result simulate(const problem::Problem& problem, const Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Plan plan = make_plan(problem, options);
  const Records records = run_streams(problem, plan, options.progress);
  const StreamWeights weights(each(records, [](const auto& r) { return r.excess_power; }));

  Result result;
  transform::Solution& solution = result.solution;
  solution.id = solution.method = "mcs";
  solution.equation = "kf";
  solution.impact = problem::Impact::exact;
  estimate_moments(records, weights, result);
  estimate_energy_residual(problem, records, weights, result);
  estimate_excess_power(problem, records, result.summary);
  estimate_efficiency(records, result);
  estimate_densities(records, plan, weights, result);
  describe(records, plan, result.summary);
  judge(solution);
  solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace fpkcheck::mcs
