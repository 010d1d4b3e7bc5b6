#include "report/page/plot.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;

TEST(Plot, HasAnElementWithItsCaptionForAllReaders) {
  const std::string html = plots_html({{"case-1-a", "1 < 2", "{}"}, {"case-1-b", "b", "{}"}});
  EXPECT_TRUE(contains(html, "<figcaption>1 &lt; 2</figcaption>"));
  EXPECT_TRUE(contains(html, "id=\"case-1-a\" role=\"img\" aria-label=\"1 &lt; 2\""));
  EXPECT_EQ(tests::occurrences(html, "<figure>"), 2u);
}

TEST(Plot, JsonHoldsTheFiguresUnderTheirElements) {
  const auto json =
      nlohmann::json::parse(plots_json({{"a\"b", "", R"({"data":[1]})"}, {"c", "", "{}"}}));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0].at("id"), "a\"b");
  EXPECT_EQ(json[0].at("figure").at("data")[0], 1);
  EXPECT_EQ(plots_json({}), "[]");
}

TEST(Plot, TextsOfPlotlyShowEveryLetter) {
  EXPECT_EQ(plotly_text("<b>a</b> &lt; 100 %"), "&lt;b>a&lt;/b> &amp;lt; 100 %");
  EXPECT_EQ(plotly_text("epc-gaussian-n6"), "epc-gaussian-n6");
}

TEST(Plot, LegendsShowTheStatusLiterally) {
  transform::Solution solution{.identity = tests::closure_identity("gaussian", 4)};
  solution.status = transform::Status::ok;
  EXPECT_EQ(legend_name(solution), "epc-gaussian-n4");
  solution.status = transform::Status::inadmissible;
  EXPECT_EQ(legend_name(solution), "epc-gaussian-n4 (inadmissible)");
  solution.identity.id = "<i>";
  EXPECT_EQ(legend_name(solution), "&lt;i> (inadmissible)");
}

TEST(Plot, DashesAreInPixels) {
  EXPECT_EQ(plotly_dash("solid"), "solid");
  EXPECT_EQ(plotly_dash("(10,4,2,4)"), "10px,4px,2px,4px");
}

}  // namespace
}  // namespace fpkcheck::report
