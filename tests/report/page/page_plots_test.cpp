#include "report/page/page_plots.hpp"

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
  EXPECT_EQ(escape_plotly_text("<b>a</b> &lt; 100 %"), "&lt;b>a&lt;/b> &amp;lt; 100 %");
  EXPECT_EQ(escape_plotly_text("epc-gaussian-n6"), "epc-gaussian-n6");
}

// A plot with two rows: a hidden line of 60 points in both, and marks with intervals in one.
Figure rows_of_curves() {
  FigureSeries line{.name = "<i>", .group = "line", .colour = "#112233", .dash = "solid"};
  line.rank = 1;
  line.is_hidden = true;
  for (int k = 0; k < 60; ++k) line.points.push_back({.x = 1.0 * k, .y = k + 0.5});
  FigureSeries marks{
      .name = "marks", .group = "marks", .colour = "#000000", .symbol = "circle-open"};
  for (int k = 0; k < 60; ++k) {
    marks.points.push_back({.x = 1.0 * k, .y = 2, .open = true, .lower = -1, .upper = 3});
  }
  marks.mark_step = 3;
  const FigureAxis x{"{/:Italic y}", 0, 60, false, 20}, linear{"p", 0, 70},
      logarithmic{"p", 0.1, 100, true};
  return {.panels = {{.id = "a",
                      .title = "",
                      .caption = "c",
                      .note = "spike",
                      .x = x,
                      .y = linear,
                      .series = {line}},
                     {.id = "a", .title = "", .x = x, .y = logarithmic, .series = {line, marks}},
                     {.title = "only in pictures", .x = x, .y = linear, .series = {line}}}};
}

TEST(Plot, PanelsWithTheSameIdAreRows) {
  const auto plots = make_page_plots(rows_of_curves(), "case-1");
  ASSERT_EQ(plots.size(), 1u);
  EXPECT_EQ(plots[0].id, "case-1-a");
  EXPECT_EQ(plots[0].caption, "c");
  const auto figure = tests::figure_of(plots[0]);
  const auto& layout = figure.at("layout");
  EXPECT_FALSE(layout.contains("hovermode"));  // one label has the values of all curves
  EXPECT_LT(layout.at("yaxis").at("domain")[1], layout.at("yaxis2").at("domain")[0]);
  EXPECT_EQ(layout.at("yaxis2").at("range"), nlohmann::json({-1.0, 2.0}));
  EXPECT_EQ(layout.at("xaxis").at("title").at("text"), "<i>y</i>");
  EXPECT_EQ(layout.at("xaxis2").at("title").at("text"), "");
  EXPECT_FALSE(layout.at("xaxis").contains("dtick"));  // zooming needs automatic steps
  EXPECT_EQ(layout.at("annotations")[0].at("text"), "spike");
}

TEST(Plot, RowsShareArraysAndEntriesOfTheLegend) {
  const auto figure = tests::figure_of(make_page_plots(rows_of_curves(), "case-1")[0]);
  EXPECT_EQ(figure.at("arrays").size(), 5u);  // abscissae; values of line, marks and band
  const auto& data = figure.at("data");
  ASSERT_EQ(data.size(), 5u);
  EXPECT_EQ(data[0].at("name"), "&lt;i>");
  EXPECT_EQ(data[0].at("visible"), "legendonly");
  EXPECT_EQ(data[0].at("legendrank"), 1);
  EXPECT_FALSE(data[0].contains("showlegend"));
  EXPECT_EQ(data[1].at("showlegend"), false);
  EXPECT_EQ(data[1].at("x"), data[0].at("x"));
  EXPECT_EQ(data[1].at("y"), data[0].at("y"));
  EXPECT_EQ(data[1].at("yaxis"), "y2");
}

TEST(Plot, IntervalsAtMarksAreABand) {
  const auto data = tests::figure_of(make_page_plots(rows_of_curves(), "case-1")[0]).at("data");
  for (const std::size_t edge : {2, 3}) {
    EXPECT_EQ(data[edge].at("hoverinfo"), "skip");
    EXPECT_EQ(data[edge].at("legendgroup"), "marks");
  }
  EXPECT_EQ(data[3].at("fill"), "tonexty");
  EXPECT_EQ(data[4].at("mode"), "markers");
  EXPECT_EQ(data[4].at("marker").at("maxdisplayed"), 20);
  EXPECT_EQ(data[4].at("marker").at("symbol")[0], "circle-open");
}

TEST(Plot, TextsOfPicturesBecomeHtml) {
  EXPECT_EQ(enhanced_text_to_plotly("{/:Italic L}_1, 10^{−3} {/:Italic y}' a\\_b<"),
            "<i>L</i><sub>1</sub>, 10<sup>−3</sup> <i>y</i>′ a_b&lt;");
}

TEST(Plot, DashesAreInPixels) {
  EXPECT_EQ(plotly_dash_type("solid"), "solid");
  EXPECT_EQ(plotly_dash_type("(10,4,2,4)"), "10px,4px,2px,4px");
}

}  // namespace
}  // namespace fpkcheck::report
