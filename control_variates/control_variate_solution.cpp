#include "control_variates/control_variate_solution.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <utility>
#include <vector>

namespace fpkcheck::control_variates {
namespace {

using transform::Solution;
using transform::StateVariable;

// The arrays transform::kMoments and control_variates::kMoments list the moments in the same order.
static_assert(std::size(transform::kMoments) == kMoments.size());

/// Adds the estimates without control variates; only these depend on the law of drawn impulses.
void add_plain_metrics(const StationaryFunctionalEstimates& estimates,
                       transform::SolverMetricsBuilder& builder) {
  for (std::size_t k = 0; k < kMoments.size(); ++k) {
    const auto& plain = estimates.moments[k].plain;
    const std::string name = transform::kMoments[k].name, error_path = "plain.errors." + name;
    builder.add(
        {.path = "plain.moments." + name, .value = plain.mean, .standard_error_path = error_path});
    builder.add_error_metric(error_path, plain.standard_error);
  }
}

void add_check_metrics(const SimulationIdentityChecks& checks,
                       transform::SolverMetricsBuilder& builder) {
  builder.add_diagnostic_metric("checks.flights.momentum", checks.momentum)
      .add_diagnostic_metric("checks.flights.virial", checks.virial)
      .add_diagnostic_metric("checks.flights.power", checks.power)
      .add_diagnostic_metric("checks.impacts.restitution", checks.restitution)
      .add_diagnostic_metric("checks.impacts.wall_distance", checks.wall_distance)
      .add_diagnostic_metric("checks.impulses.rate", checks.rate)
      .add_diagnostic_metric("checks.impulses.mean", checks.mean)
      .add_diagnostic_metric("checks.impulses.mean_square", checks.mean_square)
      .add_diagnostic_metric("checks.generator.hotelling", checks.generator.statistic)
      .add_diagnostic_metric("checks.generator.dimensions",
                             transform::value_from_count(checks.generator.dimensions))
      .add_diagnostic_metric("checks.generator.p_value", checks.generator.p_value)
      .add_diagnostic_metric("checks.plain_moments", checks.plain_moments);
}

std::string checks_note(const SimulationIdentityChecks& checks) {
  const auto failed = checks.failed_check_names();
  const std::string verdict = failed.empty()
                                  ? "all checks of motion, impacts and impulses passed"
                                  : fmt::format("failed checks: {}", fmt::join(failed, ", "));
  return fmt::format(
      "{}; Hotelling's test of zero mean of the generator on {} polynomials: p = {:.2g}", verdict,
      checks.generator.dimensions, checks.generator.p_value);
}

void set_status(const SimulationIdentityChecks& checks, Solution& solution) {
  const auto wrong = checks.failed_deterministic_check_names();
  if (wrong.empty() || !solution.has_status_ok()) return;
  solution.status = transform::Status::failed;
  solution.reason = fmt::format(
      "failed checks of {}: the simulation deviates from the problem; report this as a defect",
      fmt::join(wrong, ", "));
}

transform::SmoothBinEstimate make_smooth_bin_estimate(const SmoothBinAverageEstimates& bins,
                                                      double confidence_interval_factor) {
  std::vector<double> averages, lower, upper;
  for (const auto& [controlled, plain] : bins.averages) {
    const double half = confidence_interval_factor * controlled.standard_error;
    averages.push_back(controlled.mean);
    lower.push_back(controlled.mean - half);
    upper.push_back(controlled.mean + half);
  }
  transform::Marginal marginal = transform::smooth_bin_marginal(bins.bins, std::move(averages));
  marginal.lower = std::move(lower);
  marginal.upper = std::move(upper);
  return {.bins = bins.bins,
          .averages = std::move(marginal),
          .covariance = {bins.covariance.data(), bins.covariance.data() + bins.covariance.size()}};
}

}  // namespace

ControlVariateResult estimate_and_check_simulation(const ControlVariateSetup& setup,
                                                   mcs::SimulationResult simulation) {
  const auto streams = std::exchange(simulation.summary.deposits, {});
  const Eigen::MatrixXd generator = stream_means_of_generated_splines(setup, streams);
  StationaryFunctionalEstimates estimates = estimate_functionals(setup, generator, streams);
  const SimulationIdentityChecks judged =
      compute_simulation_identity_checks(setup, generator, streams, estimates);
  return {.estimates = std::move(estimates),
          .checks = judged,
          .simulation = std::move(simulation),
          .backward_means = setup.backward_means};
}

Solution solution_estimated_by_control_variates(ControlVariateResult&& result) {
  const auto& [estimates, checks, simulation, means] = result;
  Solution solution = std::move(result.simulation.solution);
  for (std::size_t k = 0; k < kMoments.size(); ++k) {
    const auto& controlled = estimates.moments[k].controlled;
    const auto moment = transform::kMoments[k].moment;
    solution.moments.*moment = controlled.mean;
    solution.standard_errors->moments.*moment = controlled.standard_error;
  }
  const double factor = estimates.confidence_interval_factor;
  solution.smooth_estimates = {
      {StateVariable::y, make_smooth_bin_estimate(estimates.y, factor)},
      {StateVariable::ydot, make_smooth_bin_estimate(estimates.v, factor)}};
  const auto &y = estimates.y.controlled_l1, &v = estimates.v.controlled_l1;
  solution.smooth_sampling = transform::MarginalSamplingErrors{
      .y = y.expected, .ydot = v.expected, .y_99 = y.quantile_99, .ydot_99 = v.quantile_99};
  transform::SolverMetricsBuilder builder;
  add_plain_metrics(estimates, builder);
  add_check_metrics(checks, builder);
  builder.add_text_metric("notes[0]", checks_note(checks));
  for (auto& observation : builder.take_metrics())
    solution.metrics.push_back(std::move(observation));
  set_status(checks, solution);
  return solution;
}

Solution with_note_on_missing_control_variates(Solution&& plain, const std::string& reason) {
  transform::SolverMetricsBuilder builder;
  builder.add_text_metric("notes[0]",
                          fmt::format("plain simulation without control variates: {}", reason));
  for (auto& observation : builder.take_metrics()) plain.metrics.push_back(std::move(observation));
  return std::move(plain);
}

}  // namespace fpkcheck::control_variates
