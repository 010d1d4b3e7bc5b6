#include "epc/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "closures.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc {
namespace {

using transform::find_metric;
using transform::metric_text;
using transform::Metrics;
using transform::SolverMetricKind;

double number_at(const Metrics& metrics, std::string_view path) {
  return transform::metric_number(metrics, path).value();
}

Metrics solved_metrics(int number, const ClosureOptions& options) {
  return solve_closure(tests::paper_case(number), options).solution.metrics;
}

// Names of the members of the top-level object, in order.
std::vector<std::string> top_level_names(const Metrics& metrics) {
  std::vector<std::string> names;
  for (const auto& observation : metrics) {
    const std::string name = observation.path.substr(0, observation.path.find_first_of(".["));
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

bool is_unset(const Metrics& metrics, const char* path) {
  const auto* found = find_metric(metrics, path);
  return found != nullptr && base::is_unset(found->value);
}

TEST(ClosureSummary, OfTheFormulationGaussianHasTheFieldsOfTheFiles) {
  const Metrics seen = solved_metrics(2, {.order = 6});
  EXPECT_EQ(top_level_names(seen),
            (std::vector<std::string>{"order", "formulation", "iterations", "residual", "condition",
                                      "coordinates", "log_C", "coefficients", "support",
                                      "leading_form", "distance_to_previous", "balances",
                                      "plain_newton_converges", "disc_sensitivity", "branch"}));
  EXPECT_EQ(number_at(seen, "order"), 6);
  EXPECT_EQ(metric_text(seen, "formulation"), "gaussian");
  EXPECT_EQ(metric_text(seen, "leading_form"), "indefinite");
  EXPECT_GT(number_at(seen, "iterations"), 0);
  EXPECT_LT(number_at(seen, "residual"), 1e-10);
  EXPECT_EQ(number_at(seen, "coefficients[0].x1"), 2);
  EXPECT_EQ(number_at(seen, "coefficients[0].x2"), 0);
  EXPECT_LT(number_at(seen, "coefficients[0].a"), 0);
  EXPECT_NE(find_metric(seen, "coefficients[14].a"), nullptr);
  EXPECT_EQ(find_metric(seen, "coefficients[15].a"), nullptr);
  EXPECT_GT(number_at(seen, "support.rises_from"), 4);
  EXPECT_LT(number_at(seen, "support.cut_off"), 1e-8);
  EXPECT_LT(number_at(seen, "distance_to_previous"), 0.05);
  EXPECT_TRUE(is_unset(seen, "branch"));
  EXPECT_TRUE(is_unset(seen, "disc_sensitivity"));
}

TEST(ClosureSummary, WithoutARootStatesTheEndOfTheBranch) {
  const Metrics seen = solved_metrics(1, {.order = 8});
  EXPECT_TRUE(is_unset(seen, "support"));
  EXPECT_TRUE(is_unset(seen, "leading_form"));
  EXPECT_TRUE(is_unset(seen, "coefficients[]"));
  EXPECT_TRUE(is_unset(seen, "condition"));
  EXPECT_EQ(metric_text(seen, "branch.end"), "white_noise");
  EXPECT_NEAR(number_at(seen, "branch.furthest"), 0.65475, 1e-5);
  EXPECT_EQ(number_at(seen, "branch.points[0].fraction"), 0);
  for (const auto& observation : seen) {
    if (observation.path.starts_with("branch.points")) {
      EXPECT_EQ(observation.kind, SolverMetricKind::work) << observation.path;
    }
  }
}

TEST(ClosureSummary, OnTheHalfPlaneStatesTheTail) {
  const Metrics seen = solved_metrics(1, tests::closure_options(Formulation::moment, 4));
  EXPECT_EQ(
      top_level_names(seen),
      (std::vector<std::string>{"order", "formulation", "iterations", "residual", "condition",
                                "coordinates", "log_C", "coefficients", "support", "leading_form",
                                "distance_to_previous", "balances", "tail", "quadrature_change",
                                "homotopies", "relaxation_rate", "relaxation_frequency"}));
  EXPECT_EQ(metric_text(seen, "formulation"), "moment");
  EXPECT_EQ(metric_text(seen, "tail.kind"), "confined");
  // The metric is the leading form of the exponent with its confinement; Q_n alone rises.
  EXPECT_EQ(metric_text(seen, "leading_form"), "negative");
  EXPECT_EQ(metric_text(seen, "tail.polynomial_leading_form"), "indefinite");
  EXPECT_EQ(number_at(seen, "homotopies"), 0);
}

TEST(ClosureSummary, HowTheRootWasFoundIsWork) {
  const Metrics seen = solved_metrics(1, tests::closure_options(Formulation::polar, 4));
  for (const char* path :
       {"iterations", "residual", "condition", "support.worst_direction.x1",
        "support.worst_direction.x2", "quadrature_change", "homotopies", "relaxation_rate"}) {
    EXPECT_EQ(find_metric(seen, path)->kind, SolverMetricKind::work) << path;
  }
  for (const char* path : {"order", "support.y_max", "leading_form", "tail.level"}) {
    EXPECT_EQ(find_metric(seen, path)->kind, SolverMetricKind::result) << path;
  }
}

TEST(ClosureSummary, TheEdgeIsDelicateUnlessThePathDecides) {
  const auto edge = [](int order) {
    const Metrics seen = solved_metrics(1, tests::closure_options(Formulation::moment, order));
    EXPECT_EQ(find_metric(seen, "support.cut_off")->kind,
              find_metric(seen, "support.edge_density")->kind);
    return *find_metric(seen, "support.edge_density");
  };
  EXPECT_EQ(edge(8).kind, SolverMetricKind::result);
  EXPECT_TRUE(edge(8).is_rounding_sensitive);
  EXPECT_EQ(edge(8).min_scale, 1e-6);
  EXPECT_EQ(edge(10).kind, SolverMetricKind::work);
}

// The scale of a coefficient corresponds to a change of the density of at least 1e-14 of its peak:
// max |u|^2 exp(-u^2/2) = 2/e.
TEST(ClosureSummary, ACoefficientIsKnownToWhatItDoesToTheDensity) {
  ClosureSummary summary{.order = 8, .formulation = Formulation::moment};
  summary.coefficients = {{2, 0, -0.5}, {1, 2, 0.1}, {0, 4, 1e-9}};
  const transform::Moments moments{.y2 = 4, .v2 = 0.25};
  const auto scale = [&](const char* path) {
    const auto seen = solver_metrics(summary, moments);
    EXPECT_EQ(find_metric(seen, path)->kind, SolverMetricKind::coefficient);
    return find_metric(seen, path)->min_scale * 50e-8;
  };
  const double e = std::exp(1.0);
  EXPECT_NEAR(scale("coefficients[0].a"), 1e-14 / (4 * 2 / e), 1e-24);
  EXPECT_NEAR(scale("coefficients[1].a"), 1e-14 / (2 * 0.25 * std::sqrt(1 / e) * 2 / e), 1e-24);
  EXPECT_NEAR(scale("coefficients[2].a"), 1e-14 / (0.0625 * 16 / e / e), 1e-24);
  summary.order = 10;  // the quadrature points depend on the path of the search
  EXPECT_NEAR(scale("coefficients[0].a"), 3e-9 / (4 * 2 / e), 1e-18);
  summary.formulation = Formulation::polar;
  EXPECT_NEAR(scale("coefficients[0].a"), 1e-14 / (4 * 2 / e), 1e-24);
}

}  // namespace
}  // namespace fpkcheck::epc
