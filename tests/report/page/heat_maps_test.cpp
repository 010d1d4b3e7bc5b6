#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "case_with_sources.hpp"
#include "report/figure/case_figures.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

TEST(FigureMaps, AreJsonAndEscapedHtml) {
  const auto figure = error_source_page_figure(tests::case_with_sources("<b>"));
  const std::string html = heat_maps_html(figure, "case-1", "Errors of", "<p>text</p>\n");
  EXPECT_TRUE(tests::contains(html, "<option>&lt;b&gt;</option>")) << html;
  EXPECT_TRUE(tests::contains(html, "id=\"case-1-errors-v2\""));
  const auto json = nlohmann::json::parse(heat_maps_json(figure, "case-1"));
  EXPECT_TRUE(tests::contains(html, "id=\"" + json["control"].get<std::string>() + "\""));
  ASSERT_EQ(json["choices"].size(), 2u);
  ASSERT_EQ(json["choices"][1].size(), 2u);
  const auto& map = json["choices"][0][1];
  EXPECT_EQ(map["id"], "case-1-errors-v2");
  EXPECT_EQ(map["caption"], "E[y′²]: error −0.0020");
  EXPECT_EQ(map["tickvals"].size(), map["ticktext"].size());
  EXPECT_EQ(map["steps"].size() % map["columns"].get<std::size_t>(), 0u);
}

}  // namespace
}  // namespace fpkcheck::report
