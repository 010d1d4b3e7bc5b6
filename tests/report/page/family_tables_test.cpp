#include "report/page/family_tables.hpp"

#include <gtest/gtest.h>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::row_in;
using transform::MetricBuilder;

const std::string kCaption = "Metrics of epc-gaussian";

/// A case of two closures with these metrics.
results::Case observed(transform::Metrics first, transform::Metrics second) {
  auto case_result = tests::whole_case();
  case_result.solutions.resize(2);
  case_result.solutions[0].metrics = std::move(first);
  case_result.solutions[1].metrics = std::move(second);
  return case_result;
}

TEST(FamilyTables, ShowAllMetrics) {
  const std::string html =
      family_tables(observed(MetricBuilder()
                                 .result("steps_taken", std::int64_t{12})
                                 .text("far.end", std::string("a<b"))
                                 .work("far.edge_density", 1.23456e-9)
                                 .take(),
                             MetricBuilder().result("steps_taken", 0.5).take()));
  EXPECT_EQ(tests::headers_in(html, kCaption), "quantity|n2|n4");
  EXPECT_EQ(row_in(html, kCaption, "steps taken"), "12|0.5");
  EXPECT_EQ(row_in(html, kCaption, "far: end"), "a&lt;b|\u2013");
  EXPECT_EQ(row_in(html, kCaption, "far: edge density"), "1.235e-9|\u2013");
}

TEST(FamilyTables, OmitListsAndMissingMetrics) {
  const std::string html = family_tables(observed(
      MetricBuilder().result("kept", true).result("support", {}).result("a[0].x", 1.0).take(),
      MetricBuilder().result("support", {}).add_empty_list("a").take()));
  EXPECT_EQ(row_in(html, kCaption, "kept"), "yes");
  EXPECT_EQ(tests::occurrences(html, "<th scope=\"row\">"), 1u);
}

TEST(FamilyTables, OmitRepeatedOptions) {
  auto case_result =
      observed(MetricBuilder().result("order", std::int64_t{2}).result("nodes", 3.0).take(),
               MetricBuilder().result("order", std::int64_t{4}).result("nodes", 5.0).take());
  case_result.solutions[0].options = {{"order", std::int64_t{2}}, {"nodes", {}}};
  case_result.solutions[1].options = {{"order", std::int64_t{4}}, {"nodes", 5.0}};
  const std::string html = family_tables(case_result);
  EXPECT_EQ(row_in(html, kCaption, "order"), "no row");
  EXPECT_EQ(row_in(html, kCaption, "nodes"), "3|5");  // the option of the first is automatic
}

TEST(FamilyTables, KeepTheirOrderWithGroupsBehind) {
  const std::string html = family_tables(
      observed(MetricBuilder().work("tail.b", 1.0).work("z", 1.0).take(),
               MetricBuilder().work("tail.a", 1.0).work("c", 1.0).work("z", 1.0).take()));
  const auto place = [&](const std::string& name) { return html.find('>' + name + "</th>"); };
  EXPECT_LT(place("c"), place("z"));
  EXPECT_LT(place("z"), place("tail: a"));
  EXPECT_LT(place("tail: a"), place("tail: b"));
}

TEST(FamilyTables, AreOneForEachFamily) {
  auto case_result =
      observed(MetricBuilder().work("a", 1.0).take(), MetricBuilder().work("b", 1.0).take());
  case_result.solutions[1].identity.family = "<toy>";
  const std::string html = family_tables(case_result);
  EXPECT_TRUE(contains(html, kCaption));
  EXPECT_TRUE(contains(html, "Metrics of &lt;toy&gt;"));
  EXPECT_EQ(family_tables(observed({}, {})), "");
}

}  // namespace
}  // namespace fpkcheck::report
