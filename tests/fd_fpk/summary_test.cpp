#include "fd_fpk/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

using transform::SolverMetricKind;

std::vector<std::string> paths(const transform::Metrics& metrics) {
  std::vector<std::string> list;
  for (const auto& observation : metrics) list.push_back(observation.path);
  return list;
}

const std::vector<std::string> kWithoutEstimate{"nx",
                                                "nv",
                                                "refinement",
                                                "origin_refinement",
                                                "x1_max",
                                                "x2_max",
                                                "nonzeros",
                                                "leak",
                                                "steps",
                                                "factorisations",
                                                "rhs_evaluations",
                                                "krylov_iterations",
                                                "factor_entries",
                                                "factor_seconds",
                                                "krylov_seconds",
                                                "residual",
                                                "stepped_against_direct",
                                                "regularisation_length",
                                                "growth_rate",
                                                "growth_wavenumber",
                                                "wall_density.y",
                                                "wall_density.ydot",
                                                "impact_rate",
                                                "balances.virial",
                                                "balances.momentum",
                                                "order"};

TEST(Summary, MetricsHaveTheOrderOfSummaryFiles) {
  EXPECT_EQ(paths(solver_metrics({})), kWithoutEstimate);
  auto with_estimate = kWithoutEstimate;
  with_estimate.insert(with_estimate.end(),
                       {"error.impact_rate", "error.observed_order", "error.extrapolated.y1",
                        "error.extrapolated.y2", "error.extrapolated.y4", "error.extrapolated.v1",
                        "error.extrapolated.v2", "error.extrapolated.v4"});
  EXPECT_EQ(paths(solver_metrics({.error = DiscretisationErrorEstimate{}})), with_estimate);
}

TEST(Summary, CharacteristicsHaveTheirOwnMetrics) {
  FiniteVolumeSummary summary;
  summary.transport = TransportScheme::characteristics;
  summary.visits = 1000;
  summary.rest_mass = 0.25;
  const auto all = solver_metrics(summary);
  EXPECT_EQ(find_metric(all, "transport")->value, base::Value(std::string("characteristics")));
  EXPECT_EQ(find_metric(all, "visits")->kind, SolverMetricKind::work);
  EXPECT_EQ(metric_number(all, "rest_mass"), 0.25);
}

TEST(Summary, MetricsSeparateResultsFromWork) {
  const auto all = solver_metrics({.nx = 40, .steps = 5, .wall = {1e-9, 2e-9}});
  EXPECT_EQ(find_metric(all, "nx")->value, base::Value(std::int64_t{40}));
  EXPECT_EQ(find_metric(all, "nx")->kind, SolverMetricKind::result);
  EXPECT_EQ(find_metric(all, "steps")->value, base::Value(std::int64_t{5}));
  for (const auto* work : {"nonzeros", "leak", "steps", "factorisations", "rhs_evaluations",
                           "krylov_iterations", "factor_entries", "factor_seconds",
                           "krylov_seconds", "residual", "stepped_against_direct"}) {
    EXPECT_EQ(find_metric(all, work)->kind, SolverMetricKind::work) << work;
  }
  for (const auto* result : {"refinement", "origin_refinement", "x1_max", "growth_rate",
                             "regularisation_length", "impact_rate", "wall_density.ydot"}) {
    EXPECT_EQ(find_metric(all, result)->kind, SolverMetricKind::result) << result;
  }
  EXPECT_EQ(find_metric(all, "wall_density.y")->min_scale, 1e-6);
  EXPECT_EQ(metric_number(all, "wall_density.ydot"), 2e-9);
}

// The impact rate is a result, the error of the impact rate is not. If the rate is infinite, there
// is neither metric.
TEST(Summary, AFiniteImpactRateHasAnError) {
  const auto of = [](double rate, double error) {
    return solver_metrics(
        {.error = DiscretisationErrorEstimate{.impact_rate = error}, .impact_rate = rate});
  };
  const auto all = of(0.3, 2e-4);
  EXPECT_EQ(metric_number(all, "error.impact_rate"), 2e-4);
  EXPECT_EQ(find_metric(all, "error.impact_rate")->kind, transform::SolverMetricKind::work);
  const auto infinite = of(HUGE_VAL, NAN);
  EXPECT_EQ(find_metric(infinite, "error.impact_rate"), nullptr);
  EXPECT_EQ(find_metric(infinite, "impact_rate"), nullptr);
}

TEST(Summary, ALimitIsComparedOnTheScaleOfItsMoment) {
  const auto all = solver_metrics(
      {.error = DiscretisationErrorEstimate{
           .observed_order = 4.9, .extrapolated = {.y1 = 0.01, .y2 = 3, .v1 = 1e-8, .v2 = 2}}});
  EXPECT_TRUE(find_metric(all, "error.observed_order")->is_rounding_sensitive);
  EXPECT_EQ(find_metric(all, "error.extrapolated.y1")->min_scale, 0.1);
  EXPECT_EQ(find_metric(all, "error.extrapolated.y2")->min_scale, 3);
  EXPECT_EQ(find_metric(all, "error.extrapolated.v1")->min_scale, 2);
  EXPECT_FALSE(find_metric(all, "error.extrapolated.v1")->is_rounding_sensitive);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
