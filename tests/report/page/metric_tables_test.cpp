#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::row_in;
using transform::SolverMetricsBuilder;

const std::string kCaption = "Metrics of epc-gaussian";

/// A case of two closures with these metrics.
results::CaseResult observed(transform::Metrics first, transform::Metrics second) {
  auto case_result = tests::whole_case();
  case_result.solutions.resize(2);
  case_result.solutions[0].metrics = std::move(first);
  case_result.solutions[1].metrics = std::move(second);
  return case_result;
}

TEST(FamilyTables, ShowAllMetrics) {
  const std::string html = metric_tables_html(
      observed(SolverMetricsBuilder()
                   .add_result_metric("steps_taken", std::int64_t{12})
                   .add_text_metric("far.end", std::string("a<b"))
                   .add_diagnostic_metric("far.edge_density", 1.23456e-9)
                   .take_metrics(),
               SolverMetricsBuilder().add_result_metric("steps_taken", 0.5).take_metrics()));
  EXPECT_EQ(tests::headers_in(html, kCaption), "quantity|n2|n4");
  EXPECT_EQ(row_in(html, kCaption, "steps taken"), "12|0.5");
  EXPECT_EQ(row_in(html, kCaption, "far: end"), "a&lt;b|\u2013");
  EXPECT_EQ(row_in(html, kCaption, "far: edge density"), "1.235e-9|\u2013");
}

TEST(FamilyTables, OmitListsAndMissingMetrics) {
  const std::string html = metric_tables_html(observed(
      SolverMetricsBuilder()
          .add_result_metric("kept", true)
          .add_result_metric("support", {})
          .add_result_metric("a[0].x", 1.0)
          .take_metrics(),
      SolverMetricsBuilder().add_result_metric("support", {}).add_empty_list("a").take_metrics()));
  EXPECT_EQ(row_in(html, kCaption, "kept"), "yes");
  EXPECT_EQ(tests::occurrences(html, "<th scope=\"row\">"), 1u);
}

TEST(FamilyTables, OmitRepeatedOptions) {
  auto case_result = observed(SolverMetricsBuilder()
                                  .add_result_metric("order", std::int64_t{2})
                                  .add_result_metric("nodes", 3.0)
                                  .take_metrics(),
                              SolverMetricsBuilder()
                                  .add_result_metric("order", std::int64_t{4})
                                  .add_result_metric("nodes", 5.0)
                                  .take_metrics());
  case_result.solutions[0].options = {{"order", std::int64_t{2}}, {"nodes", {}}};
  case_result.solutions[1].options = {{"order", std::int64_t{4}}, {"nodes", 5.0}};
  const std::string html = metric_tables_html(case_result);
  EXPECT_EQ(row_in(html, kCaption, "order"), "no row");
  EXPECT_EQ(row_in(html, kCaption, "nodes"), "3|5");  // the option of the first is automatic
}

TEST(FamilyTables, KeepTheirOrderWithGroupsBehind) {
  const std::string html = metric_tables_html(observed(SolverMetricsBuilder()
                                                           .add_diagnostic_metric("tail.b", 1.0)
                                                           .add_diagnostic_metric("z", 1.0)
                                                           .take_metrics(),
                                                       SolverMetricsBuilder()
                                                           .add_diagnostic_metric("tail.a", 1.0)
                                                           .add_diagnostic_metric("c", 1.0)
                                                           .add_diagnostic_metric("z", 1.0)
                                                           .take_metrics()));
  const auto place = [&](const std::string& name) { return html.find('>' + name + "</th>"); };
  EXPECT_LT(place("c"), place("z"));
  EXPECT_LT(place("z"), place("tail: a"));
  EXPECT_LT(place("tail: a"), place("tail: b"));
}

TEST(FamilyTables, AreOneForEachFamily) {
  auto case_result =
      observed(SolverMetricsBuilder().add_diagnostic_metric("a", 1.0).take_metrics(),
               SolverMetricsBuilder().add_diagnostic_metric("b", 1.0).take_metrics());
  case_result.solutions[1].identity.family = "<toy>";
  const std::string html = metric_tables_html(case_result);
  EXPECT_TRUE(contains(html, kCaption));
  EXPECT_TRUE(contains(html, "Metrics of &lt;toy&gt;"));
  EXPECT_EQ(metric_tables_html(observed({}, {})), "");
}

}  // namespace
}  // namespace fpkcheck::report
