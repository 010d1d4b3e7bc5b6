#include "mcs/summary.hpp"

#include <fmt/format.h>

#include "mcs/streams/trajectory_stream.hpp"
#include "numerics/statistics.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::SolverMetricKind;
using transform::SolverMetricsBuilder;
using transform::value_from_count;

void add_metrics(SolverMetricsBuilder& builder, const std::string& path,
                 const MeanEstimate& estimate, const std::string& error_path) {
  builder.add({.path = path, .value = estimate.mean, .standard_error_path = error_path});
  builder.add_error_metric(error_path, estimate.standard_error);
}

/// Adds the metrics of each item of a list by calling `put(path of the item, item, index)`.
template <class Item, class Put>
void add_metric_list(SolverMetricsBuilder& builder, const std::string& path,
                     const std::vector<Item>& items, SolverMetricKind kind, Put put) {
  if (items.empty()) builder.add_empty_list(path, kind);
  for (std::size_t k = 0; k < items.size(); ++k) put(fmt::format("{}[{}]", path, k), items[k], k);
}

void add_moment_metrics(SolverMetricsBuilder& builder, const std::vector<MeanEstimate>& moments) {
  add_metric_list(
      builder, "joint_moments", moments, SolverMetricKind::result,
      [&](const std::string& at, const MeanEstimate& moment, std::size_t k) {
        builder.add_result_metric(at + ".y", value_from_count(kRecordedMomentPowers[k].first));
        builder.add_result_metric(at + ".v", value_from_count(kRecordedMomentPowers[k].second));
        add_metrics(builder, at + ".mean", moment, at + ".standard_error");
      });
}

void add_quantile_metrics(SolverMetricsBuilder& builder, const std::string& path,
                          const std::vector<QuantileWithConfidenceInterval>& quantiles) {
  add_metric_list(
      builder, path, quantiles, SolverMetricKind::result,
      [&](const std::string& at, const QuantileWithConfidenceInterval& q, std::size_t) {
        const std::string error_path = at + ".standard_error";
        builder.add_result_metric(at + ".probability", q.probability);
        builder.add({.path = at + ".value", .value = q.value, .standard_error_path = error_path});
        builder.add_diagnostic_metric(at + ".lower", q.lower);
        builder.add_diagnostic_metric(at + ".upper", q.upper);
        builder.add_error_metric(error_path, (q.upper - q.lower) / (2 * numerics::kNormal95));
      });
}

void add_rate_metrics(SolverMetricsBuilder& builder, const std::string& path,
                      const std::vector<RateOfEventsAtLevel>& rates) {
  // Relative standard error of an event rate that is estimated from about 100 events; with fewer
  // events the standard error itself is inaccurate.
  constexpr double kRare = 0.1;
  add_metric_list(
      builder, path, rates, SolverMetricKind::result,
      [&](const std::string& at, const RateOfEventsAtLevel& r, std::size_t) {
        builder.add_result_metric(at + ".level", r.level);
        const std::string error_path = at + ".standard_error";
        builder.add({.path = at + ".rate",
                     .value = r.rate.mean,
                     .standard_error_path = error_path,
                     .is_rounding_sensitive = r.rate.standard_error > kRare * r.rate.mean});
        builder.add_error_metric(error_path, r.rate.standard_error);
      });
}

}  // namespace

transform::Metrics solver_metrics(const SimulationSummary& summary) {
  SolverMetricsBuilder builder;
  builder.add_diagnostic_metric("time", summary.time)
      .add_diagnostic_metric("samples", value_from_count(summary.samples))
      .add_error_metric("effective_samples", summary.effective_samples)
      .add_error_metric("effective_samples_y2", summary.effective_samples_y2);
  add_metrics(builder, "excess_power.relative", {summary.excess_power, summary.excess_power_error},
              "excess_power.standard_error");
  builder.add_diagnostic_metric("variance_reduction.y2", summary.variance_reduction_y2)
      .add_diagnostic_metric("variance_reduction.v2", summary.variance_reduction_v2)
      .add_diagnostic_metric("outside", summary.outside_fraction)
      .add_diagnostic_metric("seed", value_from_count(summary.seed))
      .add_diagnostic_metric("threads", value_from_count(summary.threads))
      .add_result_metric("streams", value_from_count(summary.streams))
      .add_result_metric("step", summary.step)
      .add_result_metric("sampling_interval", summary.sampling_interval)
      .add_result_metric("burn_in", summary.burn_in);
  if (!summary.impacts_accumulate) {
    add_metrics(builder, "impact_rate", summary.impact_rate, "impact_rate_error");
  }
  add_balance_metrics(builder, summary.balances, summary.balance_errors);
  builder.add_diagnostic_metric("impulses", value_from_count(summary.impulses))
      .add_diagnostic_metric("flights", value_from_count(summary.flights))
      .add_diagnostic_metric("rounds", value_from_count(summary.rounds))
      .add_result_metric("interrupted", summary.interrupted)
      .add_result_metric("kick_interval", transform::value_from_optional(summary.kick_interval));
  add_moment_metrics(builder, summary.joint_moments);
  add_quantile_metrics(builder, "quantiles.y", summary.y_quantiles);
  add_quantile_metrics(builder, "quantiles.ydot", summary.v_quantiles);
  add_rate_metrics(builder, "upcrossings", summary.crossings);
  add_rate_metrics(builder, "peaks", summary.peaks);
  add_metric_list(builder, "splitting_thresholds", summary.thresholds, SolverMetricKind::work,
                  [&](const std::string& at, double energy, std::size_t) {
                    builder.add_diagnostic_metric(at, energy);
                  });
  return std::move(builder).take_metrics();
}

}  // namespace fpkcheck::mcs
