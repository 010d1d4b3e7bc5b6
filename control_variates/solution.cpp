#include "control_variates/solution.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <utility>
#include <vector>

namespace fpkcheck::control_variates {
namespace {

using transform::Solution;
using transform::Variable;

static_assert(std::size(transform::kMoments) == kMoments.size());  // in the same order

/// Adds the plain estimates. They alone depend on the law of the drawn impulses.
void observe_plain(const Estimates& estimates, transform::Observer& observer) {
  for (std::size_t k = 0; k < kMoments.size(); ++k) {
    const auto& plain = estimates.moments[k].plain;
    const std::string name = transform::kMoments[k].name, error_path = "plain.errors." + name;
    observer.add({.path = "plain.moments." + name, .value = plain.mean, .error_at = error_path});
    observer.error(error_path, plain.standard_error);
  }
}

void observe_checks(const Checks& checks, transform::Observer& observer) {
  observer.work("checks.flights.momentum", checks.momentum)
      .work("checks.flights.virial", checks.virial)
      .work("checks.flights.power", checks.power)
      .work("checks.impacts.restitution", checks.restitution)
      .work("checks.impacts.wall_distance", checks.wall_distance)
      .work("checks.impulses.rate", checks.rate)
      .work("checks.impulses.mean", checks.mean)
      .work("checks.impulses.mean_square", checks.mean_square)
      .work("checks.generator.hotelling", checks.generator.statistic)
      .work("checks.generator.dimensions", transform::counted(checks.generator.dimensions))
      .work("checks.generator.p_value", checks.generator.p_value)
      .work("checks.plain_moments", checks.plain_moments);
}

std::string note_of(const Checks& checks) {
  const auto failed = checks.failed();
  const std::string verdict = failed.empty()
                                  ? "all checks of motion, impacts and impulses passed"
                                  : fmt::format("failed checks: {}", fmt::join(failed, ", "));
  return fmt::format(
      "{}; Hotelling's test of zero mean of the generator on {} polynomials: p = {:.2g}", verdict,
      checks.generator.dimensions, checks.generator.p_value);
}

void judge(const Checks& checks, Solution& solution) {
  const auto wrong = checks.certainly_wrong();
  if (wrong.empty() || !solution.is_ok()) return;
  solution.status = transform::Status::failed;
  solution.reason = fmt::format(
      "failed checks of {}: the simulation deviates from the problem; report this as a defect",
      fmt::join(wrong, ", "));
}

transform::SmoothEstimate smooth_estimate(const BinEstimates& bins, double interval_factor) {
  std::vector<double> averages, lower, upper;
  for (const auto& [controlled, plain] : bins.averages) {
    const double half = interval_factor * controlled.standard_error;
    averages.push_back(controlled.mean);
    lower.push_back(controlled.mean - half);
    upper.push_back(controlled.mean + half);
  }
  transform::Marginal marginal = transform::marginal_of(bins.bins, std::move(averages));
  marginal.lower = std::move(lower);
  marginal.upper = std::move(upper);
  return {.bins = bins.bins,
          .averages = std::move(marginal),
          .covariance = {bins.covariance.data(), bins.covariance.data() + bins.covariance.size()}};
}

}  // namespace

Solution solution_of(Result&& result) {
  const auto& [estimates, checks, simulation, means] = result;
  Solution solution = std::move(result.simulation.solution);
  for (std::size_t k = 0; k < kMoments.size(); ++k) {
    const auto& controlled = estimates.moments[k].controlled;
    const auto moment = transform::kMoments[k].moment;
    solution.moments.*moment = controlled.mean;
    solution.standard_errors->moments.*moment = controlled.standard_error;
  }
  const double factor = estimates.interval_factor;
  solution.smooth_estimates = {{Variable::y, smooth_estimate(estimates.y, factor)},
                               {Variable::ydot, smooth_estimate(estimates.v, factor)}};
  const auto &y = estimates.y.controlled_l1, &v = estimates.v.controlled_l1;
  solution.smooth_sampling = transform::SamplingError{
      .y = y.expected, .ydot = v.expected, .y_99 = y.in_99, .ydot_99 = v.in_99};
  transform::Observer observer;
  observe_plain(estimates, observer);
  observe_checks(checks, observer);
  observer.text("notes[0]", note_of(checks));
  for (auto& observation : observer.take()) solution.observations.push_back(std::move(observation));
  judge(checks, solution);
  return solution;
}

Solution without_control(Solution&& plain, const std::string& why) {
  transform::Observer observer;
  observer.text("notes[0]", fmt::format("plain simulation without control variates: {}", why));
  for (auto& observation : observer.take()) plain.observations.push_back(std::move(observation));
  return std::move(plain);
}

}  // namespace fpkcheck::control_variates
