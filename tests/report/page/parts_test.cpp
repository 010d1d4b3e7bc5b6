#include "report/page/parts.hpp"

#include <gtest/gtest.h>

#include <string>

namespace fpkcheck::report {
namespace {

TEST(PageParts, AreTheFilesWhole) {
  EXPECT_TRUE(page_frame().starts_with("<!doctype html>"));
  EXPECT_TRUE(page_frame().ends_with("</html>\n"));
  EXPECT_NE(page_style().find("@media print"), std::string::npos);
  EXPECT_NE(page_script().find("'drawn'"), std::string::npos);
  EXPECT_GT(plotly_script().size(), 500'000u);
}

TEST(PageParts, TheFrameHasAPlaceForEach) {
  for (const std::string place : {"title", "style", "body", "plots", "plotly", "script"}) {
    EXPECT_NE(page_frame().find("{{" + place + "}}"), std::string::npos) << place;
  }
}

}  // namespace
}  // namespace fpkcheck::report
