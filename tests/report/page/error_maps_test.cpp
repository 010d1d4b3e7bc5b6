#include "report/page/error_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case_with_sources.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

TEST(ErrorMaps, AreOfAllThatHaveTheirSourcesClosuresFirst) {
  const auto maps = error_maps(tests::case_with_sources());
  ASSERT_TRUE(maps);
  ASSERT_EQ(maps->solutions.size(), 2u);
  EXPECT_EQ(maps->solutions[0].solution, "epc-gaussian-n6");
  EXPECT_EQ(maps->solutions[1].solution, "fd-kf");
  for (const auto& [id, moments] : maps->solutions) {
    ASSERT_EQ(moments.size(), 2u);
    const double size = id == "fd-kf" ? 1e-3 : 1;
    EXPECT_EQ(moments[0].error, 1e-3 * size);
    EXPECT_EQ(moments[1].error, -2e-3 * size);
    for (const auto& map : moments) {
      EXPECT_EQ(map.values.roots.size(), (maps->y_edges.size() - 1) * (maps->v_edges.size() - 1));
      // The largest value is at the wall, at y' > 0.
      const auto largest = std::ranges::find_if(
          map.values.roots, [&](auto root) { return std::abs(root) == map.values.levels; });
      const auto place = static_cast<std::size_t>(largest - map.values.roots.begin());
      EXPECT_EQ(place % (maps->y_edges.size() - 1), 0u);
      EXPECT_GE(maps->v_edges[place / (maps->y_edges.size() - 1)], 0);
      EXPECT_EQ(*largest > 0, map.error > 0);
    }
  }
}

TEST(ErrorMaps, AreNoneWithoutSourcesOrOnOtherCells) {
  EXPECT_FALSE(error_maps(tests::made_up_case()));
  auto case_result = tests::case_with_sources();
  case_result.error_sources[1].density.y_edges.back() += 1;
  EXPECT_FALSE(error_maps(case_result));
  case_result = tests::case_with_sources();
  case_result.joints.clear();
  EXPECT_FALSE(error_maps(case_result));
}

TEST(ErrorMaps, AreJsonAndEscapedHtml) {
  auto case_result = tests::case_with_sources();
  for (auto& s : case_result.solutions) {
    if (s.id() == "fd-kf") s.identity.id = "<b>";
  }
  for (auto& own : case_result.moment_error_estimates)
    own.solution = own.solution == "fd-kf" ? "<b>" : own.solution;
  for (auto& s : case_result.error_sources) s.solution = s.solution == "fd-kf" ? "<b>" : s.solution;
  const auto maps = error_maps(case_result);
  ASSERT_TRUE(maps);
  const std::string html = error_maps_html(*maps, "case-1");
  EXPECT_TRUE(tests::contains(html, "<option>&lt;b&gt;</option>")) << html;
  EXPECT_TRUE(tests::contains(html, "id=\"case-1-errors-map1\""));
  const auto json = nlohmann::json::parse(error_maps_json(*maps, "case-1"));
  EXPECT_EQ(json["solutions"][1]["solution"], "<b>");
  EXPECT_EQ(json["solutions"][0]["moments"][1]["error"], "-0.0020");
}

}  // namespace
}  // namespace fpkcheck::report
