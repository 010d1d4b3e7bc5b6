#include "compare/case_report.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "compare/summary.hpp"
#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

TEST(CaseReport, ComparesEveryPairWithADensityAgainstTheMoreTrusted) {
  const auto report = tests::full_report();
  // Seven of the eight solutions have a density.
  EXPECT_EQ(report.marginals.size(), 2 * 7u);
  ASSERT_EQ(report.comparisons.size(), 2 * 21u);
  EXPECT_EQ(report.comparisons.front().a, "epc-gaussian-n2");
  EXPECT_EQ(report.comparisons.front().b, "epc-gaussian-n4");
  EXPECT_EQ(report.comparisons.front().variable, Variable::y);
  EXPECT_EQ(report.comparisons.back().a, "fd-kf");
  EXPECT_EQ(report.comparisons.back().b, "mcs");
  EXPECT_EQ(report.comparisons.back().variable, Variable::ydot);
  const auto& white = report.marginals[3];
  const auto& kf = report.marginals[5];
  ASSERT_EQ(white.solution + kf.solution, "fd-whitefd-kf");
  for (const auto& comparison : report.comparisons) {
    if (comparison.a != "fd-white" || comparison.b != "fd-kf") continue;
    if (comparison.variable != Variable::y) continue;
    EXPECT_EQ(comparison.distances.kl, distances(white.marginal, kf.marginal).kl);
    EXPECT_NE(comparison.distances.kl, distances(kf.marginal, white.marginal).kl);
  }
}

TEST(CaseReport, ComparesWhatIsNotOkToo) {
  const auto report = tests::full_report();
  ASSERT_EQ(report.entries[1].solution.status, transform::Status::inadmissible);
  EXPECT_EQ(report.marginals[1].solution, report.entries[1].solution.id);
}

TEST(CaseReport, UsesTheSimulationsOwnHistogram) {
  const auto report = tests::full_report();
  const auto& own = report.entries.back().solution.estimated_marginals.front().second;
  const auto& used = report.marginals[6];
  ASSERT_EQ(used.solution, "mcs");
  EXPECT_EQ(used.marginal.density, own.density);
  EXPECT_EQ(used.marginal.lower, own.lower);
}

TEST(CaseReport, ComparesTheMarginalOfTheVariableItNames) {
  const auto report = tests::full_report();
  // Made with the same p(y), and with another p(y').
  std::vector<Entry> entries;
  for (const double quartic : {0.0, 0.1}) {
    entries.push_back(tests::entry(quartic > 0 ? "flat" : "normal", "fd", "kf",
                                   problem::Impact::map, tests::smooth({2, 0, 2, quartic}, 5, 5)));
  }
  const auto two = report_on_case(report.problem, report.axes, entries);
  ASSERT_EQ(two.comparisons.size(), 2u);
  EXPECT_LT(two.comparisons[0].distances.l1, 1e-9);
  EXPECT_GT(two.comparisons[1].distances.l1, 1e-2);
}

Json made_up_summary() {
  return summary("fpkcheck run", std::vector<CaseReport>{tests::full_report()});
}

TEST(Summary, HasEveryFieldOfTheContract) {
  const Json json = made_up_summary();
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("program").at("name"), "fpkcheck");
  EXPECT_EQ(json.at("program").at("command"), "fpkcheck run");
  EXPECT_EQ(json.at("program").at("version"), program_version());
  EXPECT_NE(program_version().find('.'), std::string::npos);
  const Json& c = json.at("cases").at(0);
  EXPECT_EQ(c.at("name"), "case1");
  EXPECT_EQ(c.at("system").at("damping"), 0.1);
  EXPECT_EQ(c.at("system").at("stiffness"), 1.0);
  EXPECT_EQ(c.at("system").at("cubic"), 0.1);
  EXPECT_EQ(c.at("system").at("restitution"), 0.98);
  EXPECT_EQ(c.at("impulse").at("rate"), 1.0);
  EXPECT_EQ(c.at("impulse").at("law"), "gaussian");
  EXPECT_NEAR(c.at("impulse").at("intensity").get<double>(), 0.1, 1e-15);
  EXPECT_EQ(c.at("impulse").at("mean"), 0.0);
  ASSERT_EQ(c.at("impulse").at("moments").size(), 7u);
  EXPECT_NEAR(c.at("impulse").at("moments").at(4).get<double>(), 0.03, 1e-15);
  EXPECT_TRUE(c.at("budget").is_array());

  const Json& s = c.at("solutions").at(0);
  EXPECT_EQ(s.at("id"), "epc-gaussian-n2");
  EXPECT_EQ(s.at("method"), "epc");
  EXPECT_EQ(s.at("equation"), "km4");
  EXPECT_EQ(s.at("impact"), "delta");
  EXPECT_EQ(s.at("status"), "ok");
  EXPECT_EQ(s.at("reason"), "");
  EXPECT_EQ(s.at("seconds"), 0.42);
  EXPECT_TRUE(s.at("options").is_object());
  for (const char* key : {"y1", "y2", "y4", "v1", "v2", "v4"}) {
    EXPECT_TRUE(s.at("moments").at(key).is_number()) << key;
  }
  for (const char* key : {"mass", "min_density", "energy_residual"}) {
    EXPECT_TRUE(s.at(key).is_number()) << key;
  }
  EXPECT_EQ(s.at("order"), 2);  // a detail of the method

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
}

TEST(Summary, MomentsAreThoseOfTheSolution) {
  auto report = tests::full_report();
  report.entries[0].solution.moments = {1, 2, 3, 4, 5, 6};
  const Json json = summary("", std::vector<CaseReport>{report});
  EXPECT_EQ(json["cases"][0]["solutions"][0]["moments"].dump(),
            R"({"y1":1.0,"y2":2.0,"y4":3.0,"v1":4.0,"v2":5.0,"v4":6.0})");
}

TEST(Summary, WhatIsNotFiniteOrNotKnownIsNull) {
  auto report = tests::full_report();
  report.entries[0].solution.energy_residual = std::nan("");
  report.entries[0].details["residuals"] = {1.0, std::numeric_limits<double>::infinity()};
  report.comparisons[0].distances.kl = std::numeric_limits<double>::infinity();
  const Json json = summary("", std::vector<CaseReport>{report});
  const Json& c = json["cases"][0];
  EXPECT_TRUE(c["solutions"][0]["energy_residual"].is_null());
  EXPECT_EQ(c["solutions"][0]["residuals"].dump(), "[1.0,null]");
  EXPECT_TRUE(c["comparisons"][0]["kl"].is_null());
  ASSERT_EQ(c["solutions"][3]["id"], "epc-gaussian-n8");
  EXPECT_TRUE(c["solutions"][3]["moments"].is_null());
  EXPECT_TRUE(c["solutions"][3]["mass"].is_null());
  EXPECT_EQ(Json::parse(json.dump()), json);
}

TEST(Summary, DetailsMustNotClaimACommonField) {
  auto report = tests::full_report();
  report.entries[0].details["status"] = "fine";
  EXPECT_THROW(summary("", std::vector<CaseReport>{report}), std::logic_error);
  report.entries[0].details = Json::array({1});
  EXPECT_THROW(summary("", std::vector<CaseReport>{report}), std::logic_error);
  report.entries[0].details = nullptr;
  EXPECT_NO_THROW(summary("", std::vector<CaseReport>{report}));
}

}  // namespace
}  // namespace fpkcheck::compare
