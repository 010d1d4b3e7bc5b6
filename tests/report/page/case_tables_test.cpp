#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::headers_in;
using tests::row_in;
using tests::solution_of;
using tests::whole_case;

TEST(ResultsTable, HasDistancesToTheReferenceFirst) {
  const auto case_result = whole_case();
  const std::string html = solutions_table_html(case_result);
  EXPECT_EQ(headers_in(html, "All solutions"),
            "solution|solves|status|E[y]|E[y\u00b2]|E[y\u2032\u00b2]|E[y\u2074]|E[y\u2032\u2074]|"
            "L1 to fd-kf, p(y)|L1 to fd-kf, p(y\u2032)|L1 to mcs, p(y)|L1 to mcs, p(y\u2032)|"
            "mass \u2212 1|energy residual|seconds");
  EXPECT_TRUE(row_in(html, "All solutions", "fd-white").starts_with("white/map|ok|0."));
  EXPECT_TRUE(row_in(html, "All solutions", "mcs").ends_with("|\u2013|\u2013|0|-2e-3|0.42"));
}

TEST(ResultsTable, FollowsTheRuleForTheReference) {
  auto case_result = whole_case();
  solution_of(case_result, "fd-kf").error.reset();
  case_result.update_assessment();
  EXPECT_TRUE(tests::contains(headers_in(solutions_table_html(case_result), "All solutions"),
                              "|L1 to mcs, p(y)|L1 to mcs, p(y\u2032)|L1 to fd-kf, p(y)|"));
  for (const char* id : {"fd-kf", "mcs"})
    solution_of(case_result, id).status = transform::Status::failed;
  case_result.update_assessment();
  EXPECT_FALSE(tests::contains(solutions_table_html(case_result), "L1 to"));
}

TEST(MomentErrors, AreDistancesFromTheMiddleOfTheBounds) {
  auto case_result = whole_case();
  EXPECT_EQ(guaranteed_bound_errors_table_html(case_result), "");
  const double y2 = case_result.find("fd-kf")->moments.y2;
  case_result.bounds =
      compare::GuaranteedBounds{.each = {{"E[y^2]", y2 - 1e-3, y2 + 3e-3}, {"w1", 1, 2}}};
  solution_of(case_result, "fd-white").moments.y2 = y2 + 5e-3;
  const std::string html = guaranteed_bound_errors_table_html(case_result);
  const std::string caption = "Errors of moments, from the guaranteed bounds";
  EXPECT_TRUE(tests::contains(headers_in(html, caption), "solution|E[y\u00b2] in ["));
  EXPECT_FALSE(tests::contains(html, "w1"));
  EXPECT_EQ(row_in(html, caption, "fd-kf"), "within");
  EXPECT_EQ(row_in(html, caption, "fd-white"), "0.0040");
}

TEST(Reasons, AreOfThoseThatAreNotOk) {
  auto case_result = whole_case();
  solution_of(case_result, "epc-gaussian-n4").reason = "because 1 < 2";
  const std::string html = status_reasons_html(case_result);
  EXPECT_EQ(tests::occurrences(html, "<li>"), 2u);
  EXPECT_TRUE(tests::contains(
      html, "<li><strong>epc-gaussian-n4 inadmissible</strong>: because 1 &lt; 2.</li>"));
  for (auto& solution : case_result.solutions) solution.status = transform::Status::ok;
  EXPECT_EQ(status_reasons_html(case_result), "");
}

TEST(Diagnostics, HaveErrorEstimatesOfAllSolutions) {
  auto case_result = whole_case();
  solution_of(case_result, "fd-kf").min_density = -3e-11;
  const std::string html = diagnostics_tables_html(case_result);
  const std::string caption = "Mass, energy and error estimates";
  EXPECT_EQ(
      headers_in(html, caption),
      "solution|status|minimum density / peak|mass \u2212 1|energy residual|standard error of "
      "the energy residual|error estimate of p(y), L1|error estimate of p(y\u2032), L1|"
      "sampling error of p(y), L1|sampling error of p(y\u2032), L1|"
      "standard error of E[y\u00b2]|standard error of E[y\u2032\u00b2]");
  const auto row = [&](const std::string& id) {
    std::string text = row_in(html, caption, id);
    for (auto at = text.find("\u2013"); at != std::string::npos; at = text.find("\u2013")) {
      text.replace(at, std::string("\u2013").size(), "-");
    }
    return text;
  };
  EXPECT_EQ(row("fd-kf"), "ok|-3e-11|0|-2e-3|-|2.0e-5|3.0e-5|-|-|-|-");
  EXPECT_EQ(row("mcs"), "ok|0|0|-2e-3|0|-|-|0.0011|0.0015|0.00010|0.00010");
  EXPECT_EQ(row("epc-gaussian-n8"), "not_converged|-|-|-|-|-|-|-|-|-|-");
}

TEST(Diagnostics, ContainTheMetricsOfFamilies) {
  EXPECT_TRUE(tests::contains(diagnostics_tables_html(whole_case()), "Metrics of mcs"));
}

}  // namespace
}  // namespace fpkcheck::report
