#include "workflows/study/transient/comparison_over_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/input_error.hpp"
#include "gunzip_base64.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::study {
namespace {

using Json = nlohmann::json;
using transform::ErrorEstimate;
using transform::Status;
using transform::TransientDensities;
using transform::TransientDensitySnapshot;

// Densities over two bins of width 1, with the probability p in the first bin.
TransientDensitySnapshot snapshot(double time, double p, double y2,
                                  std::optional<ErrorEstimate> error) {
  return {.time = time,
          .moments = {.y2 = y2, .v2 = 1},
          .y = {.edges = {0, 1, 2}, .density = {p, 1 - p}, .lower = {}, .upper = {}},
          .ydot = {.edges = {-1, 0, 1}, .density = {0.5, 0.5}, .lower = {}, .upper = {}},
          .error = error};
}

TransientDensities solution(const std::string& id, double p, double estimate) {
  const ErrorEstimate error{.y_l1 = estimate, .ydot_l1 = 0, .moments = {.y2 = 0.3, .v2 = 0.1}};
  return {.id = id,
          .status = Status::ok,
          .snapshots = {snapshot(0, 0.9, 1, error), snapshot(2, p, 2, error)}};
}

TransientComparison made_up_comparison() {
  TransientComparison study{tests::paper_case(1), {}, {}};
  study.options.until = 2;
  study.options.snapshots = 1;
  study.options.methods = "epc-polar-n6,fd-kf,mcs";
  study.solutions = {solution("epc-polar-n6", 0.8, 0.2), solution("fd-kf", 0.75, 0.001),
                     solution("mcs", 0.74, 0.02)};
  study.solutions[2].has_standard_errors = true;
  for (auto& s : study.solutions[2].snapshots) {
    s.y.lower = s.y.upper = s.y.density;
    s.ydot.lower = s.ydot.upper = s.ydot.density;
  }
  return study;
}

TEST(TransientComparison, ComparesWithFiniteVolumesAndElseWithTheSimulation) {
  TransientComparison study = made_up_comparison();
  ASSERT_NE(find_reference_solution(study), nullptr);
  EXPECT_EQ(find_reference_solution(study)->id, "fd-kf");
  study.solutions[1].snapshots.pop_back();
  EXPECT_EQ(find_reference_solution(study)->id, "mcs");
  study.solutions[2].snapshots.clear();
  EXPECT_EQ(find_reference_solution(study), nullptr);
  EXPECT_TRUE(study_figure(study).panels.empty());
  EXPECT_TRUE(study_netcdf_bytes(study, "fpkcheck run").empty());
  EXPECT_FALSE(study_table_text(study, {}).empty());
}

TEST(TransientComparison, HasTheKeysOfTheContract) {
  const Json found =
      Json::parse(study_json_text(made_up_comparison(), "fpkcheck run case1 --until 2"));
  const Json& list = found.at("cases").at(0).at("over_time");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].at("solution"), "epc-polar-n6");
  EXPECT_EQ(list[0].at("times"), Json({0.0, 2.0}));
  EXPECT_EQ(list[0].at("moments").at(1).at("y2"), 2.0);
  EXPECT_EQ(list[0].at("error").at(1).at("y2"), 0.3);
  EXPECT_NEAR(list[0].at("l1").at(1).at("y").get<double>(), 2 * 0.05, 1e-12);
  EXPECT_EQ(list[0].at("l1").at(1).at("ydot"), 0.0);
  EXPECT_TRUE(list[1].at("l1").at(1).is_null());
  EXPECT_EQ(list[2].at("standard_errors").at(0).at("v2"), 0.1);
  EXPECT_FALSE(list[2].contains("error"));
}

TEST(TransientComparison, WritesARowOfTheCsvForEachBin) {
  const std::string text = study_csv_text(made_up_comparison());
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 3 * 2 * 4);
  EXPECT_TRUE(text.starts_with("case,solution,time,variable,abscissa,density,lower,upper\n"));
  EXPECT_NE(text.find("test,epc-polar-n6,2,y,0.5,0.8,,\n"), std::string::npos) << text;
  EXPECT_NE(text.find("test,mcs,2,y,0.5,0.74,0.74,0.74\n"), std::string::npos) << text;
}

TEST(TransientComparison, DrawsMomentsDistancesAndDensities) {
  const report::Figure drawn = study_figure(made_up_comparison());
  ASSERT_EQ(drawn.panels.size(), 6u);
  EXPECT_EQ(drawn.panels[0].series.size(), 3u);
  ASSERT_EQ(drawn.panels[2].series.size(), 2u);
  EXPECT_NEAR(drawn.panels[2].series[0].points[1].y, 0.1, 1e-12);
  EXPECT_TRUE(drawn.panels[4].map && drawn.panels[5].map);
}

// Values of a curve of a plot on the page.
Json curve(const Json& plot, const std::string& solution, const std::string& axis) {
  for (const Json& trace : plot.at("figure").at("data")) {
    if (trace.at("legendgroup") == solution && trace.at("yaxis") == axis &&
        trace.value("hoverinfo", "") != "skip") {
      return trace.at("y");
    }
  }
  return nullptr;
}

TEST(TransientComparison, HasAPageWithThePlotsAndTheTableOfEachTime) {
  TransientComparison study = made_up_comparison();
  study.problem.name = "a<b";
  study.solutions.push_back(solution("epc-moment-n6", 0.6, 0.2));
  study.options.methods += ",epc-moment-n6";
  study.solutions.back().snapshots.pop_back();  // no density at the end time
  const std::string html = study_page_html(study, "fpkcheck run");
  EXPECT_NE(html.find("<title>fpkcheck: densities over time of a&lt;b</title>"), std::string::npos);
  EXPECT_EQ(html.find("a<b"), std::string::npos);
  EXPECT_NE(html.find("min=\"0\" max=\"1\" step=\"1\" value=\"1\""), std::string::npos);
  for (const char* fetched : {"src=", "<link", "@import", "href=\"http"}) {
    EXPECT_EQ(html.find(fetched), std::string::npos) << fetched;
  }
  const auto table = html.find("<caption>Moments and L1 distances at t = 2</caption>");
  ASSERT_NE(table, std::string::npos);
  EXPECT_LT(html.find("<caption>Moments and L1 distances at t = 0</caption>"), table);
  const auto row = html.find("epc-polar-n6</th>", table);
  EXPECT_TRUE(html.substr(html.find("<td", row))
                  .starts_with("<td class=\"number\">0.10</td><td class=\"number\">0.20</td>"
                               "<td class=\"number\">0</td><td class=\"number\">0</td>"));
  EXPECT_NE(html.find("2.00000 \u00b1 3.0e-01", row), std::string::npos);

  const Json group = tests::plots_in(html).at(0);
  EXPECT_EQ(group.at("plots").size(), 4u);
  const Json& slider = group.at("slider");
  EXPECT_EQ(slider.at("labels"), Json({"t = 0", "t = 2"}));
  const Json& steps = slider.at("steps");
  ASSERT_EQ(steps.size(), 2u);
  for (const Json& step : steps) {
    ASSERT_EQ(step.size(), 2u);
    EXPECT_EQ(step[0].at("id"), "over-time-density-y");
    EXPECT_EQ(step[1].at("id"), "over-time-density-ydot");
    EXPECT_EQ(step[0].at("figure").at("layout"), steps[0][0].at("figure").at("layout"));
  }
  // The rows of a plot, from the lowest: density, logarithm, difference from the reference.
  EXPECT_EQ(curve(steps[0][0], "epc-polar-n6", "y"), Json({0.9, 1 - 0.9}));
  EXPECT_EQ(curve(steps[1][0], "epc-polar-n6", "y"), Json({0.8, 1 - 0.8}));
  EXPECT_EQ(curve(steps[1][0], "epc-polar-n6", "y3"), Json({0.8 - 0.75, (1 - 0.8) - 0.25}));
  EXPECT_EQ(curve(steps[1][0], "epc-moment-n6", "y"), Json({nullptr, nullptr}));
  EXPECT_EQ(steps[0][0].at("figure").at("data").size(), steps[1][0].at("figure").at("data").size());
  EXPECT_GT(steps[0][0].at("figure").at("layout").at("yaxis3").at("range").at(1), 0.05);

  study.solutions[1].snapshots.clear();
  study.solutions[2].snapshots.clear();
  EXPECT_TRUE(study_page_html(study, "fpkcheck run").empty());
}

TEST(TransientComparison, ShowsAtMostTheRequestedNumberOfIntervals) {
  TransientComparison study = made_up_comparison();
  study.options.snapshots = 25;
  EXPECT_EQ(evenly_spaced_snapshots(study, 10),
            (std::vector<std::size_t>{0, 3, 6, 9, 12, 15, 18, 21, 24, 25}));
  EXPECT_EQ(evenly_spaced_snapshots(study, 100).size(), 26u);
}

TEST(TransientComparison, ConvergesIfFiniteVolumesAndSimulationAreOk) {
  TransientComparison study = made_up_comparison();
  study.solutions[0].status = Status::inaccurate;
  EXPECT_TRUE(has_converged(study));
  study.solutions[1].status = Status::failed;
  EXPECT_FALSE(has_converged(study));
}

// The simulation is the reference. The closure of order 2 has no estimate of its own.
TEST(TransientComparison, JudgesClosuresByTheDistanceToTheReference) {
  TransientComparisonOptions options;
  options.until = 1;
  options.snapshots = 1;
  options.methods = "epc-moment-n2,mcs";
  options.time = 2e4;
  options.accuracy = 1;
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const TransientComparison lenient = compare_over_time(problem, options, {});
  ASSERT_EQ(lenient.solutions.size(), 2u);
  EXPECT_EQ(lenient.solutions[0].status, Status::ok) << lenient.solutions[0].reason;
  EXPECT_FALSE(lenient.solutions[0].snapshots[1].error);
  options.accuracy = 1e-3;
  const TransientComparison strict = compare_over_time(problem, options, {});
  EXPECT_EQ(strict.solutions[0].status, Status::inaccurate);
  EXPECT_FALSE(strict.solutions[0].reason.empty());
  EXPECT_EQ(strict.solutions[1].status, Status::ok);
}

TEST(TransientComparison, RequiresTheAccuracyOfTheEstimateAndOfTheDistance) {
  const auto judged = [](double p, double estimate, double of_reference, bool is_compared) {
    const TransientDensities compared_with = solution("fd-kf", 0.75, of_reference);
    TransientDensities closure = solution("epc-polar-n6", p, estimate);
    require_accurate(0.01, is_compared ? &compared_with : nullptr, closure);
    return closure;
  };
  // The arguments are the probability (distance 2 |p - 0.75|), and the errors of both solutions.
  EXPECT_EQ(judged(0.75, 0.005, 0.001, true).status, Status::ok);
  EXPECT_EQ(judged(0.75, 0.02, 0.001, true).status, Status::ok) << "the distance is smaller";
  EXPECT_EQ(judged(0.80, 0.005, 0.001, true).status, Status::inaccurate) << "contradiction";
  EXPECT_EQ(judged(0.75, 0.02, 0.001, false).status, Status::inaccurate);
  EXPECT_EQ(judged(0.75, 0.005, 0.001, false).status, Status::ok);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judged(0.75, 0.005, none, true).status, Status::ok);
  EXPECT_EQ(judged(0.75, none, none, true).status, Status::inaccurate);
  EXPECT_EQ(judged(0.75, none, 0.001, true).status, Status::ok);

  TransientDensities outside = solution("mcs", 0.75, 0.001);
  outside.has_standard_errors = true;
  outside.snapshots[1].y.density[0] -= 0.01;
  require_accurate(0.01, nullptr, outside);
  EXPECT_EQ(outside.status, Status::inaccurate) << "a mass of 0.01 is outside the bins";
}

// A mean far beyond the stationary density: the bins contain the density.
TEST(TransientComparison, HasBinsForTheInitialDensity) {
  TransientComparisonOptions options;
  options.until = 1;
  options.snapshots = 1;
  options.methods = "mcs";
  options.time = 3e3;
  options.start_mean_y = 12;
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const TransientComparison study = compare_over_time(problem, options, {});
  EXPECT_EQ(study.solutions.at(0).status, Status::ok) << study.solutions.at(0).reason;
  EXPECT_GT(study.solutions[0].snapshots[0].y.edges.back(), 12);
}

TEST(TransientComparison, RefusesUnknownMethods) {
  TransientComparisonOptions options;
  options.until = 1;
  for (const char* methods : {"", "foo", "epc", "epc-polar-n7", "epc-moment-n100"}) {
    options.methods = methods;
    EXPECT_THROW(compare_over_time(tests::paper_case(1), options, {}), InputError) << methods;
  }
}

}  // namespace
}  // namespace fpkcheck::study
