#include "results/run_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "general_oscillators.hpp"
#include "refusal.hpp"
#include "saved_run.hpp"

namespace fpkcheck::results {
namespace {

using Json = nlohmann::ordered_json;
using tests::contains;
using transform::SolverMetricKind;
using transform::SolverMetricsBuilder;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Json summary_of(const results::Run& run) { return Json::parse(run_summary_text(run)); }

results::Run read(const std::string& text) {
  std::istringstream in(text);
  return read_run_summary(in, "summary.json");
}

std::string refusal(const std::string& text) {
  return tests::refusal([&] { read(text); });
}

TEST(RunJson, ContainsTheStopMessage) {
  const results::Run whole{{"fpkcheck", "1", "fpkcheck run"}, {}};
  EXPECT_FALSE(summary_of(whole).contains("stopped"));
  const results::Run stopped{{"fpkcheck", "1", "fpkcheck run"}, {}, "Stopped. Missing: case2."};
  EXPECT_EQ(read(run_summary_text(stopped)).stopped, stopped.stopped);
  EXPECT_EQ(read(run_summary_text(whole)).stopped, "");
}

// A run with a value in every field.
results::Run full_run() {
  results::Run run = tests::made_up_run();
  auto& solutions = run.cases[0].solutions;
  solutions[0].options = {{"order", std::int64_t{2}}, {"tail", std::string("cut")}, {"nx", {}}};
  solutions[0].metrics = SolverMetricsBuilder()
                             .add_result_metric("order", std::int64_t{2})
                             .add_diagnostic_metric("iterations", std::int64_t{7})
                             .add_result_metric("coefficients[0].x1", std::int64_t{2})
                             .add_result_metric("coefficients[0].a", -0.25)
                             .add_result_metric("coefficients[1].x1", std::int64_t{0})
                             .add_result_metric("support.edge_density", 1e-9)
                             .add_result_metric("branch", {})
                             .add_text_metric("leading_form", std::string("negative"))
                             .add_result_metric("falls", true)
                             .add_empty_list("branches")
                             .take_metrics();
  solutions[6].error = {.y_l1 = 1e-5, .ydot_l1 = 2e-5, .moments = {1, 2, 3, 4, 5, 6}};
  solutions[6].metrics =
      SolverMetricsBuilder().add_result_metric("error.observed_order", 4.9).take_metrics();
  solutions[7].sampling = {.y = 1e-4, .ydot = {}, .y_99 = 2e-4, .ydot_99 = {}};
  run.cases[0].bounds = compare::GuaranteedBounds{.reason = "wider than asked for",
                                                  .seconds = 0.5,
                                                  .each = {{"E[y^2]", 0.125, 0.25}, {"w1", 1, 2}}};
  run.cases[0].update_assessment();
  return run;
}

TEST(Summary, BoundsAreReadBack) {
  const auto bounds = read(run_summary_text(full_run())).cases[0].bounds;
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->reason, "wider than asked for");
  EXPECT_EQ(bounds->each, full_run().cases[0].bounds->each);
  EXPECT_FALSE(read(run_summary_text(tests::made_up_run())).cases[0].bounds);
}

TEST(Summary, AtomsAreReadBack) {
  results::Run run = tests::made_up_run();
  auto& solution = run.cases[0].solutions.back();
  EXPECT_FALSE(summary_of(run)["cases"][0]["solutions"].back().contains("atoms"));
  solution.atoms = {{.y = -0.5, .probability = 0.25, .standard_error = 0.01},
                    {.y = 0.5, .probability = 0.125, .error_estimate = 0.02}};
  const auto again = read(run_summary_text(run)).cases[0].solutions.back().atoms;
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].y, -0.5);
  EXPECT_EQ(again[0].probability, 0.25);
  EXPECT_EQ(again[0].standard_error, 0.01);
  EXPECT_FALSE(again[0].error_estimate);
  EXPECT_EQ(again[1].error_estimate, 0.02);
}

TEST(Summary, OfAnotherOscillatorIsReadBack) {
  results::Run run = tests::made_up_run();
  run.cases[0].problem =
      tests::with_noise(problem::System({.damping = -1, .van_der_pol = 1, .stiffness = 1},
                                        {.right = 2, .right_restitution = 0.9}),
                        0.4);
  const Json json = summary_of(run)["cases"][0];
  EXPECT_FALSE(json.contains("impulse"));
  EXPECT_EQ(json["noise"].dump(), R"({"intensity":0.4})");
  EXPECT_EQ(json["wall"].dump(), R"({"right":2.0,"right_restitution":0.9})");
  const auto again = read(run_summary_text(run)).cases[0].problem;
  EXPECT_EQ(problem::non_default_parameters_text(again),
            problem::non_default_parameters_text(run.cases[0].problem));
}

TEST(Summary, HasEveryFieldOfTheContract) {
  const Json json = summary_of(full_run());
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("program").at("name"), "fpkcheck");
  EXPECT_EQ(json.at("program").at("command"), "fpkcheck run");
  EXPECT_EQ(json.at("program").at("version"), current_program("").version);
  EXPECT_NE(current_program("").version.find('.'), std::string::npos);
  const Json& c = json.at("cases").at(0);
  EXPECT_EQ(c.at("name"), "case1");
  EXPECT_EQ(c.at("system").dump(),
            R"({"damping":0.1,"stiffness":1.0,"cubic":0.1,"restitution":0.98})");
  EXPECT_EQ(c.at("impulse").at("rate"), 1.0);
  EXPECT_EQ(c.at("impulse").at("law"), "gaussian");
  EXPECT_NEAR(c.at("impulse").at("intensity").get<double>(), 0.1, 1e-15);
  EXPECT_EQ(c.at("impulse").at("mean"), 0.0);
  ASSERT_EQ(c.at("impulse").at("moments").size(), 7u);
  EXPECT_NEAR(c.at("impulse").at("moments").at(4).get<double>(), 0.03, 1e-15);

  const Json& s = c.at("solutions").at(0);
  EXPECT_EQ(s.at("id"), "epc-gaussian-n2");
  EXPECT_EQ(s.at("method"), "epc");
  EXPECT_EQ(s.at("equation"), "km4");
  EXPECT_EQ(s.at("impact"), "delta");
  EXPECT_EQ(s.at("status"), "ok");
  EXPECT_EQ(s.at("reason"), "");
  EXPECT_EQ(s.at("seconds"), 0.42);
  EXPECT_EQ(s.at("options").dump(), R"({"order":2,"tail":"cut","nx":null})");
  for (const char* key : {"y1", "y2", "y4", "v1", "v2", "v4"}) {
    EXPECT_TRUE(s.at("moments").at(key).is_number()) << key;
  }
  for (const char* key : {"mass", "min_density", "energy_residual"}) {
    EXPECT_TRUE(s.at(key).is_number()) << key;
  }
  EXPECT_EQ(s.at("order"), 2);  // a metric of the solver
  EXPECT_EQ(s.at("coefficients").dump(), R"([{"x1":2,"a":-0.25},{"x1":0}])");
  EXPECT_EQ(s.at("support").dump(), R"({"edge_density":1e-09})");
  EXPECT_EQ(s.at("branches").dump(), "[]");
  EXPECT_EQ(s.at("identity").at("role"), "closure");
  EXPECT_EQ(s.at("identity").at("order"), 2);
  const Json& fd = c.at("solutions").at(6);
  EXPECT_EQ(fd.at("error").at("y_l1"), 1e-5);
  EXPECT_EQ(fd.at("error").at("moments").at("v4"), 6.0);
  EXPECT_EQ(fd.at("error").at("observed_order"), 4.9);
  const Json& mcs = c.at("solutions").at(7);
  EXPECT_EQ(mcs.at("standard_errors").at("y2"), 1e-4);
  EXPECT_EQ(mcs.at("sampling_l1").dump(), R"({"y":0.0001,"y_99":0.0002})");

  const Json& d = c.at("comparisons").at(0);
  EXPECT_EQ(d.at("a"), "epc-gaussian-n2");
  EXPECT_EQ(d.at("b"), "epc-gaussian-n4");
  EXPECT_EQ(d.at("variable"), "y");
  for (const char* key : {"l1", "l2", "sup", "hellinger", "kl"}) {
    EXPECT_TRUE(d.at(key).is_number()) << key;
  }
  for (const char* key : {"from", "to", "mean_abs"}) {
    EXPECT_TRUE(d.at("log10_tail").at(0).contains(key)) << key;
  }
  const Json& row = c.at("budget").at(0);
  EXPECT_EQ(row.at("tail").dump().substr(0, 25), R"({"from":1e-05,"to":0.001,)");
  EXPECT_EQ(row.at("parts").back().contains("expected"), true);
  EXPECT_EQ(c.at("reference"), "fd-kf");
  const Json& assessment = c.at("assessment");
  EXPECT_EQ(assessment.at("reference").dump(),
            R"({"solution":"fd-kf","selected_by":"error_estimate","y_l1":1e-05,"ydot_l1":2e-05})");
  EXPECT_EQ(assessment.at("confirmation").at("solution"), "mcs");
  EXPECT_TRUE(assessment.at("confirmation").at("agrees").is_boolean());
  ASSERT_EQ(assessment.at("solutions").size(), c.at("solutions").size());
  const Json& closure = assessment.at("solutions").at(0);
  EXPECT_EQ(closure.at("solution"), "epc-gaussian-n2");
  EXPECT_EQ(closure.at("agreement"), "close");
  EXPECT_TRUE(closure.at("y_l1").is_number());
  EXPECT_EQ(closure.at("rank"), 2);
  EXPECT_TRUE(assessment.at("solutions").at(6).at("rank").is_null());
  const Json& limit = assessment.at("limiting_errors").at(0);
  EXPECT_TRUE(limit.at("part").is_null() || limit.at("part").is_string());
  EXPECT_EQ(limit.at("solutions").at(0), "epc-gaussian-n2");
  EXPECT_LE(limit.at("least_fraction"), limit.at("greatest_fraction"));
  EXPECT_TRUE(assessment.at("reference_disagreement").is_boolean());
}

TEST(Summary, OfAnOlderVersionIsAssessedWhenRead) {
  const results::Run run = full_run();
  Json json = summary_of(run);
  json["cases"][0].erase("assessment");
  EXPECT_EQ(read(json.dump()).cases[0].assessment, run.cases[0].assessment);
}

TEST(Summary, HasTheStoredAssessment) {
  Json json = summary_of(full_run());
  Json& assessment = json["cases"][0]["assessment"];
  assessment["solutions"][0]["agreement"] = "distant";  // a reader repeats no assessment
  EXPECT_EQ(read(json.dump()).cases[0].assessment.solutions[0].agreement,
            compare::AgreementWithReference::distant);
  for (const auto& [field, value] : {std::pair{"solution", "nobody"}, {"agreement", "great"}}) {
    Json wrong = json;
    wrong["cases"][0]["assessment"]["solutions"][0][field] = value;
    EXPECT_TRUE(contains(refusal(wrong.dump()), "assessment")) << field;
  }
  Json wrong = json;
  wrong["cases"][0]["assessment"]["limiting_errors"][0]["solutions"][0] = "nobody";
  EXPECT_TRUE(contains(refusal(wrong.dump()), "limiting_errors"));
  assessment["solutions"].erase(0);
  EXPECT_TRUE(contains(refusal(json.dump()), "other solutions"));
}

TEST(Summary, IsReadBackAsItWas) {
  const std::string text = run_summary_text(full_run());
  const results::Run run = read(text);
  EXPECT_EQ(run_summary_text(run), text);
  const auto& solution = run.cases[0].solutions[0];
  EXPECT_TRUE(solution.has_density());
  EXPECT_FALSE(solution.density);
  EXPECT_FALSE(run.cases[0].solutions[3].has_density());
  EXPECT_EQ(transform::metric_number(solution.metrics, "coefficients[0].a"), -0.25);
  EXPECT_EQ(transform::metric_text(solution.metrics, "leading_form"), "negative");
  EXPECT_EQ(run.cases[0].budget[0].parts[0].approximations.front(),
            compare::ModelApproximation::closure);
}

TEST(Summary, NonFiniteAndUnknownNumbersAreNull) {
  results::Run run = full_run();
  auto& one = run.cases[0];
  one.solutions[0].energy_residual = std::nan("");
  one.solutions[0].metrics = SolverMetricsBuilder()
                                 .add_result_metric("residuals[0]", 1.0)
                                 .add_result_metric("residuals[1]", kInfinity)
                                 .take_metrics();
  one.pairs[0].distances.kl = kInfinity;
  one.budget[0].total_tail = std::nan("");
  const Json json = summary_of(run);
  const Json& c = json["cases"][0];
  EXPECT_TRUE(c["solutions"][0]["energy_residual"].is_null());
  EXPECT_EQ(c["solutions"][0]["residuals"].dump(), "[1.0,null]");
  EXPECT_TRUE(c["comparisons"][0]["kl"].is_null());
  EXPECT_TRUE(c["budget"][0]["total_tail"].is_null());
  ASSERT_EQ(c["solutions"][3]["id"], "epc-gaussian-n8");
  EXPECT_TRUE(c["solutions"][3]["moments"].is_null());
  EXPECT_TRUE(c["solutions"][3]["mass"].is_null());
  const results::Run again = read(run_summary_text(run));
  EXPECT_TRUE(std::isnan(again.cases[0].solutions[0].energy_residual));
  EXPECT_EQ(again.cases[0].pairs[0].distances.kl, kInfinity);
  EXPECT_TRUE(std::isnan(again.cases[0].budget[0].total_tail));
}

TEST(Summary, MetricsMustNotReuseKeys) {
  for (const char* path : {"status", "moments.y2", "sampling_l1.y"}) {
    results::Run run = full_run();
    run.cases[0].solutions[0].metrics =
        SolverMetricsBuilder().add_result_metric(path, 1.0).take_metrics();
    EXPECT_THROW(run_summary_text(run), std::logic_error) << path;
  }
  results::Run run = full_run();
  run.cases[0].solutions[0].metrics = SolverMetricsBuilder()
                                          .add_result_metric("nx", 1.0)
                                          .add_result_metric("nx", 2.0)
                                          .take_metrics();
  EXPECT_THROW(run_summary_text(run), std::logic_error);
  run.cases[0].solutions[0].metrics = SolverMetricsBuilder()
                                          .add_result_metric("nx", 1.0)
                                          .add_result_metric("nx.more", 2.0)
                                          .take_metrics();
  EXPECT_THROW(run_summary_text(run), std::logic_error);
}

TEST(Summary, OfAnOlderVersionHasSolutionsWithoutAFamily) {
  Json json = summary_of(full_run());
  for (auto& solution : json["cases"][0]["solutions"]) solution.erase("identity");
  json["cases"][0].erase("reference");
  const results::Run run = read(json.dump());
  EXPECT_EQ(run.cases[0].solutions[0].identity.family, "");
  EXPECT_EQ(run.cases[0].solutions[0].id(), "epc-gaussian-n2");
}

TEST(Summary, RefusesCorruptFiles) {
  const std::string text = run_summary_text(full_run());
  EXPECT_TRUE(contains(refusal(text.substr(0, 1000)), "is not JSON: error at byte"));
  EXPECT_TRUE(contains(refusal("[]"), "\"schema\" is missing"));
  EXPECT_TRUE(
      contains(refusal(R"({"schema": 7})"), "has schema 7, but this program reads schema 1"));
  EXPECT_TRUE(contains(refusal(R"({"schema": 1e999})"), "is not JSON"));
  Json json = Json::parse(text);
  json["cases"][0]["solutions"][0].erase("status");
  EXPECT_TRUE(contains(refusal(json.dump()), "key 'status' not found")) << refusal(json.dump());
  json = Json::parse(text);
  json["cases"].push_back(json["cases"][0]);
  EXPECT_TRUE(contains(refusal(json.dump()), "case1 occurs twice"));
  json = Json::parse(text);
  json["cases"][0]["solutions"][1]["id"] = "epc-gaussian-n2";
  EXPECT_TRUE(contains(refusal(json.dump()), "epc-gaussian-n2 occurs twice"));
  json = Json::parse(text);
  json["cases"][0]["system"]["restitution"] = 1.5;
  EXPECT_TRUE(contains(refusal(json.dump()), "system.restitution = 1.5"));
  json["cases"][0]["system"]["restitution"] = "much";
  EXPECT_TRUE(contains(refusal(json.dump()), "system.restitution = 'much'"));
  json = Json::parse(text);
  json["cases"][0]["system"]["colour"] = 1;
  EXPECT_TRUE(contains(refusal(json.dump()), "system.colour is unknown"));
  for (const auto& broken : {refusal(json.dump()), refusal(text.substr(0, 1000))}) {
    EXPECT_TRUE(contains(broken, "summary.json"));
    EXPECT_FALSE(contains(broken, "\n"));
  }
}

// The conversion of a number out of the range of int is undefined behaviour.
TEST(Summary, RefusesNonIntegers) {
  for (const Json& wrong : {Json(1e300), Json(-1e300), Json(3000000000), Json(1.5), Json("6")}) {
    for (const char* place : {"/order", "/trust", "/look/layer"}) {
      Json json = Json::parse(run_summary_text(full_run()));
      json["cases"][0]["solutions"][0]["identity"][Json::json_pointer(place)] = wrong;
      EXPECT_TRUE(contains(refusal(json.dump()), "(must be an integer")) << place << wrong;
    }
  }
  Json json = Json::parse(run_summary_text(full_run()));
  json["cases"][0]["comparisons"][0]["log10_tail"] =
      Json::array({{{"from", 1}, {"to", 0}, {"mean_abs", 1}, {"bins", 1e300}, {"left_out", 0}}});
  EXPECT_TRUE(contains(refusal(json.dump()), "\"bins\" is 1e+300 (must be an integer"));
}

// Recursion into deeply nested JSON must not exhaust the stack.
TEST(Summary, RefusesDeepNesting) {
  const std::string opening(100000, '[');
  EXPECT_TRUE(contains(refusal(opening + std::string(100000, ']')), "nested more than"));
  EXPECT_TRUE(contains(refusal(opening), "nested more than"));
  std::string objects;
  for (int k = 0; k < 100000; ++k) objects += R"({"a":)";
  EXPECT_TRUE(contains(refusal(objects), "nested more than"));
}

}  // namespace
}  // namespace fpkcheck::results
