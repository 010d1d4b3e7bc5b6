#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"
#include "workflows/sweep/report/page/sweep_page.hpp"
#include "workflows/sweep/report/sweep_tables.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

TEST(SweepPage, DescribesTheVariedKeys) {
  const auto results = tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates});
  const std::string page = sweep_page(results, {}, "fpkcheck sweep");
  EXPECT_TRUE(contains(page, "system.restitution from 0.6 to 1 (5 values, evenly spaced)"));
  EXPECT_TRUE(contains(page, "every value with every other. 15 points, each solved by 4 methods."));
  EXPECT_TRUE(contains(page, "The same at all points: ")) << page;
  EXPECT_FALSE(contains(page, "r = "));  // varies
  EXPECT_FALSE(contains(page, "so far"));
}

TEST(SweepPage, ReportsMissingPoints) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points.pop_back();
  EXPECT_TRUE(contains(sweep_page(results, {}, ""), "4 points solved so far"));
  EXPECT_FALSE(contains(sweep_page(results, {}, ""), "there is no reference"));
  for (auto& point : results.points) point.reference.clear();
  EXPECT_TRUE(contains(sweep_page(results, {}, ""), "there is no reference"));
}

TEST(SweepPage, HasTheNumbersOfTheTerminal) {
  const auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  const std::string page = sweep_page(results, {}, "");
  for (const auto& column : method_table_columns(results)) {
    for (const auto& cell : column.cells) {
      if (cell == report::kMissingCell) continue;
      EXPECT_TRUE(contains(page, '>' + cell + "</t")) << column.header << ' ' << cell;
    }
  }
}

TEST(SweepPage, GroupsReasonsWithAnExample) {
  const std::string page = sweep_page(tests::made_up_sweep({tests::kFiveRestitutions}), {}, "");
  EXPECT_TRUE(contains(page,
                       "<strong>epc-gaussian-n4 inadmissible</strong>, 4 points, first at "
                       "system.restitution = 0.6: it is 0.5 off."))
      << page;
}

TEST(SweepPage, EscapesExternalText) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.plan.base.name = "<b>case</b>";
  results.points[0].methods[0].reason = "<script>alert(1)</script> & more";
  const std::string page =
      sweep_page(results, {{"\"quoted\" <i>", "image/png", "PNG"}}, "fpkcheck '<img src=x>'");
  for (const char* raw : {"<b>case", "<script", "<img src=x", "\"quoted\"", "<i>"}) {
    EXPECT_FALSE(contains(page, raw)) << raw;
  }
  EXPECT_TRUE(contains(page, "&lt;script&gt;alert(1)&lt;/script&gt; &amp; more"));
  EXPECT_TRUE(contains(page, "&lt;img src=x&gt;"));
}

TEST(SweepPage, EmbedsItsPictures) {
  const std::string page = sweep_page(tests::made_up_sweep({tests::kFiveRestitutions}),
                                      {{"what it shows", "image/svg+xml", "<svg/>"}}, "");
  EXPECT_TRUE(contains(page, "src=\"data:image/svg+xml;base64,PHN2Zy8+\""));
  EXPECT_TRUE(contains(page, "<figcaption>what it shows</figcaption>"));
  EXPECT_TRUE(contains(page, "default-src 'none'"));
  for (const char* outside : {"http:", "https:", "<link", "url("}) {
    EXPECT_FALSE(contains(page, outside)) << outside;
  }
}

TEST(Reasons, AreGroupedWithoutTheirNumbers) {
  EXPECT_EQ(replace_numbers_by_dots("residual 1.5e-03 > 1e-6 after 20 steps"),
            "residual ... > ... after ... steps");
  EXPECT_EQ(replace_numbers_by_dots("at (-0.5, 3)."), "at (..., ...).");
  EXPECT_EQ(replace_numbers_by_dots("km4 of epc-moment-n8: L1 of 2.0"),
            "km4 of epc-moment-n8: L1 of ...");
  EXPECT_EQ(replace_numbers_by_dots("1e5 cells, 2 errors"), "... cells, ... errors");
  EXPECT_EQ(replace_numbers_by_dots("a-b 3e"), "a-b ...e");
  EXPECT_EQ(replace_numbers_by_dots(""), "");
}

TEST(Reasons, AreGroupedTheMostFrequentFirst) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points[3].methods[tests::made_up_moment] = tests::made_up_failure();
  const auto groups = status_reason_groups(results);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].method, std::size_t{tests::made_up_gaussian});
  EXPECT_EQ(groups[0].count, 4u);
  EXPECT_EQ(groups[0].point, 0u);
  EXPECT_EQ(groups[0].reason, "it is 0.5 off");
  EXPECT_EQ(groups[1].status, transform::Status::failed);
  EXPECT_EQ(groups[1].count, 1u);
  EXPECT_EQ(groups[1].point, 3u);
}

}  // namespace
}  // namespace fpkcheck::sweep
