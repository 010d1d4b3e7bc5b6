#include "workflows/sweep/report/page/sweep_page.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"
#include "workflows/sweep/report/method_columns.hpp"

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
  for (const auto& column : method_columns(results)) {
    for (const auto& cell : column.cells) {
      if (cell == report::kAbsent) continue;
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

}  // namespace
}  // namespace fpkcheck::sweep
