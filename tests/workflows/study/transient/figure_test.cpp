#include <gtest/gtest.h>

#include "made_up_transient.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::study {
namespace {

using tests::contains;

TEST(TransientFigure, IsDrawnOfBothMarginals) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings =
      write_transient(directory.path(), tests::made_up_transient(600),
                      {.formats = {report::FigureFormat::png, report::FigureFormat::svg}});
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const auto stem = directory.path() / "figures" / "transient-it_s_a__case_";
  EXPECT_TRUE(tests::contents(stem.string() + ".png").starts_with("\x89PNG\r\n\x1a\n"));
  const std::string svg = tests::contents(stem.string() + ".svg");
  for (const char* text : {"it's a_{case}: c = 0.1", "(a) displacement", "(b) velocity"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
}

}  // namespace
}  // namespace fpkcheck::study
