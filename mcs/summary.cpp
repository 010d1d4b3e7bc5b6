#include "mcs/summary.hpp"

#include <fmt/format.h>

#include "mcs/streams/stream.hpp"
#include "numerics/statistics.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::MetricBuilder;
using transform::MetricKind;
using transform::value_from_count;

void add_metrics(MetricBuilder& builder, const std::string& path, const MeanEstimate& estimate,
                 const std::string& error_path) {
  builder.add({.path = path, .value = estimate.mean, .standard_error_path = error_path});
  builder.add_error(error_path, estimate.standard_error);
}

/// Adds the metrics of each item of a list by calling `put(path of the item, item, index)`.
template <class Item, class Put>
void add_metric_list(MetricBuilder& builder, const std::string& path,
                     const std::vector<Item>& items, MetricKind kind, Put put) {
  if (items.empty()) builder.add_empty_list(path, kind);
  for (std::size_t k = 0; k < items.size(); ++k) put(fmt::format("{}[{}]", path, k), items[k], k);
}

void add_moment_metrics(MetricBuilder& builder, const std::vector<MeanEstimate>& moments) {
  add_metric_list(builder, "joint_moments", moments, MetricKind::result,
                  [&](const std::string& at, const MeanEstimate& moment, std::size_t k) {
                    builder.add_result(at + ".y", value_from_count(kPowers[k].first));
                    builder.add_result(at + ".v", value_from_count(kPowers[k].second));
                    add_metrics(builder, at + ".mean", moment, at + ".standard_error");
                  });
}

void add_quantile_metrics(MetricBuilder& builder, const std::string& path,
                          const std::vector<QuantileEstimate>& quantiles) {
  add_metric_list(
      builder, path, quantiles, MetricKind::result,
      [&](const std::string& at, const QuantileEstimate& q, std::size_t) {
        const std::string error_path = at + ".standard_error";
        builder.add_result(at + ".probability", q.probability);
        builder.add({.path = at + ".value", .value = q.value, .standard_error_path = error_path});
        builder.add_diagnostic(at + ".lower", q.lower);
        builder.add_diagnostic(at + ".upper", q.upper);
        builder.add_error(error_path, (q.upper - q.lower) / (2 * numerics::kNormal95));
      });
}

void add_rate_metrics(MetricBuilder& builder, const std::string& path,
                      const std::vector<LevelEventRate>& rates) {
  // Relative standard error of a rate from about 100 events; with fewer events the standard error
  // itself is inaccurate.
  constexpr double kRare = 0.1;
  add_metric_list(
      builder, path, rates, MetricKind::result,
      [&](const std::string& at, const LevelEventRate& r, std::size_t) {
        builder.add_result(at + ".level", r.level);
        const std::string error_path = at + ".standard_error";
        builder.add({.path = at + ".rate",
                     .value = r.rate.mean,
                     .standard_error_path = error_path,
                     .is_rounding_sensitive = r.rate.standard_error > kRare * r.rate.mean});
        builder.add_error(error_path, r.rate.standard_error);
      });
}

}  // namespace

transform::Metrics metrics(const Summary& summary) {
  MetricBuilder builder;
  builder.add_diagnostic("time", summary.time)
      .add_diagnostic("samples", value_from_count(summary.samples))
      .add_error("effective_samples", summary.effective_samples)
      .add_error("effective_samples_y2", summary.effective_samples_y2);
  add_metrics(builder, "excess_power.relative", {summary.excess_power, summary.excess_power_error},
              "excess_power.standard_error");
  builder.add_diagnostic("variance_reduction.y2", summary.variance_reduction_y2)
      .add_diagnostic("variance_reduction.v2", summary.variance_reduction_v2)
      .add_diagnostic("outside", summary.outside_fraction)
      .add_diagnostic("seed", value_from_count(summary.seed))
      .add_diagnostic("threads", value_from_count(summary.threads))
      .add_result("streams", value_from_count(summary.streams))
      .add_result("step", summary.step)
      .add_result("sampling_interval", summary.sampling_interval)
      .add_result("burn_in", summary.burn_in);
  if (!summary.impacts_accumulate) {
    add_metrics(builder, "impact_rate", summary.impact_rate, "impact_rate_error");
  }
  add_balance_metrics(builder, summary.balances, summary.balance_errors);
  builder.add_diagnostic("impulses", value_from_count(summary.impulses))
      .add_diagnostic("flights", value_from_count(summary.flights))
      .add_diagnostic("rounds", value_from_count(summary.rounds))
      .add_result("interrupted", summary.interrupted)
      .add_result("kick_interval", transform::value_from_optional(summary.kick_interval));
  add_moment_metrics(builder, summary.joint_moments);
  add_quantile_metrics(builder, "quantiles.y", summary.y_quantiles);
  add_quantile_metrics(builder, "quantiles.ydot", summary.v_quantiles);
  add_rate_metrics(builder, "upcrossings", summary.crossings);
  add_rate_metrics(builder, "peaks", summary.peaks);
  add_metric_list(builder, "splitting_thresholds", summary.thresholds, MetricKind::work,
                  [&](const std::string& at, double energy, std::size_t) {
                    builder.add_diagnostic(at, energy);
                  });
  return std::move(builder).take_metrics();
}

}  // namespace fpkcheck::mcs
