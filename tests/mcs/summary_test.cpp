#include "mcs/summary.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mcs/streams/trajectory_stream.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::Metrics;
using transform::SolverMetric;
using transform::SolverMetricKind;

SimulationSummary made_up_summary() {
  SimulationSummary summary;
  summary.excess_power = 1e-3;
  summary.excess_power_error = 2e-3;
  summary.impact_rate = {0.3, 0.01};
  summary.kick_interval = 0.05;
  summary.joint_moments.assign(kRecordedMomentPowers.size(), {1.5, 0.1});
  summary.y_quantiles = {{.probability = 0.5, .value = 0.6, .lower = 0.59, .upper = 0.62}};
  summary.crossings = {{.level = 0.5, .rate = {0.2, 0.02}}};
  summary.peaks = {{.level = 0, .rate = {0.4, 0.02}}, {.level = 0.5, .rate = {0.3, 0.02}}};
  summary.thresholds = {1.0, 2.0};
  return summary;
}

const SolverMetric& metric_at_path(const Metrics& all, const std::string& path) {
  const SolverMetric* found = transform::find_metric(all, path);
  if (found == nullptr) throw std::logic_error("no " + path);
  return *found;
}

// Each metric with a standard_error_path is a number, and its standard error is a metric at this
// path.
TEST(Summary, RandomResultsHaveStandardErrors) {
  const auto all = solver_metrics(made_up_summary());
  int with_error = 0;
  for (const auto& observation : all) {
    if (observation.standard_error_path.empty()) continue;
    ++with_error;
    EXPECT_EQ(observation.kind, SolverMetricKind::result) << observation.path;
    EXPECT_EQ(metric_at_path(all, observation.standard_error_path).kind, SolverMetricKind::error)
        << observation.path;
    EXPECT_GT(transform::metric_number(all, observation.standard_error_path), 0)
        << observation.path;
  }
  EXPECT_EQ(with_error, 1 + 1 + static_cast<int>(kRecordedMomentPowers.size()) + 1 + 1 + 2);
  EXPECT_EQ(metric_at_path(all, "excess_power.relative").standard_error_path,
            "excess_power.standard_error");
  EXPECT_EQ(metric_at_path(all, "impact_rate").standard_error_path, "impact_rate_error");
  EXPECT_EQ(metric_at_path(all, "joint_moments[13].mean").standard_error_path,
            "joint_moments[13].standard_error");
  EXPECT_EQ(metric_at_path(all, "peaks[1].rate").standard_error_path, "peaks[1].standard_error");
  // A 95 % interval of a normal variable is 2 * 1.96 standard errors wide.
  EXPECT_NEAR(*transform::metric_number(all, "quantiles.y[0].standard_error"),
              0.03 / (2 * 1.959964), 1e-15);
}

TEST(Summary, HasTheFieldsOfFilesInTheirOrder) {
  std::vector<std::string> fields;
  for (const auto& observation : solver_metrics(made_up_summary())) {
    const std::string field = observation.path.substr(0, observation.path.find_first_of(".["));
    if (fields.empty() || fields.back() != field) fields.push_back(field);
  }
  EXPECT_EQ(fields, (std::vector<std::string>{"time",
                                              "samples",
                                              "effective_samples",
                                              "effective_samples_y2",
                                              "excess_power",
                                              "variance_reduction",
                                              "outside",
                                              "seed",
                                              "threads",
                                              "streams",
                                              "step",
                                              "sampling_interval",
                                              "burn_in",
                                              "impact_rate",
                                              "impact_rate_error",
                                              "balances",
                                              "impulses",
                                              "flights",
                                              "rounds",
                                              "interrupted",
                                              "kick_interval",
                                              "joint_moments",
                                              "quantiles",
                                              "upcrossings",
                                              "peaks",
                                              "splitting_thresholds"}));
  EXPECT_EQ(metric_at_path(solver_metrics(made_up_summary()), "quantiles.ydot[]").kind,
            SolverMetricKind::result);
  EXPECT_EQ(metric_at_path(solver_metrics(made_up_summary()), "joint_moments[7].y").value,
            transform::value_from_count(1));
  EXPECT_EQ(metric_at_path(solver_metrics(made_up_summary()), "joint_moments[7].v").value,
            transform::value_from_count(2));
}

TEST(Summary, HasTheKindsOfItsMetrics) {
  const auto all = solver_metrics(made_up_summary());
  for (const char* path : {"time", "samples", "threads", "seed", "impulses", "flights", "rounds",
                           "outside", "variance_reduction.y2", "variance_reduction.v2",
                           "splitting_thresholds[1]", "quantiles.y[0].lower"}) {
    EXPECT_EQ(metric_at_path(all, path).kind, SolverMetricKind::work) << path;
  }
  for (const char* path : {"effective_samples", "effective_samples_y2", "impact_rate_error"}) {
    EXPECT_EQ(metric_at_path(all, path).kind, SolverMetricKind::error) << path;
  }
  for (const char* path : {"streams", "step", "sampling_interval", "burn_in", "interrupted",
                           "kick_interval", "peaks[0].level", "quantiles.y[0].probability"}) {
    EXPECT_EQ(metric_at_path(all, path).kind, SolverMetricKind::result) << path;
  }
  const auto without = solver_metrics({});
  EXPECT_TRUE(base::is_unset(metric_at_path(without, "kick_interval").value));
  EXPECT_EQ(metric_at_path(without, "splitting_thresholds[]").kind, SolverMetricKind::work);
}

}  // namespace
}  // namespace fpkcheck::mcs
