#include "compare/figure/pictures.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstdlib>
#include <sstream>

#include "compare/report.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;
using tests::gnuplot_exists;
using tests::made_up_run;

TEST(Pictures, AreAPngAndAnSvg) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run("it's a_{case}");
  const auto warnings = draw_pictures(directory.path(), run.summary, run.marginals);
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const std::string png = contents(directory.path() / "figures" / "it_s_a__case_.png");
  const std::string svg = contents(directory.path() / "figures" / "it_s_a__case_.svg");
  EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
  EXPECT_TRUE(contains(png, "IEND"));
  EXPECT_GT(png.size(), 20000u);
  boost::property_tree::ptree parsed;
  std::istringstream xml(svg);
  ASSERT_NO_THROW(boost::property_tree::read_xml(xml, parsed));
  EXPECT_EQ(parsed.count("svg"), 1u);
  for (const char* text : {"it's a_{case}: c = 0.1", "fd-white", "epc-gaussian-n4 (inadmissible)",
                           "mcs, with 95 % intervals", "(a) displacement",
                           "(d) velocity, logarithmic", "(f) velocity, difference from fd-kf"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
  EXPECT_FALSE(contains(svg, "epc-gaussian-n8"));  // it has no density
}

TEST(Pictures, TheScriptDrawsTheSameAgainByHand) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run();
  draw_pictures(directory.path(), run.summary, run.marginals);
  const fs::path figures = directory.path() / "figures";
  const std::string first = contents(figures / "case1.svg");
  fs::remove(figures / "case1.svg");
  const std::string command =
      "cd '" + figures.string() + "' && gnuplot -e \"format='svg'\" case1.gp";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(contents(figures / "case1.svg"), first);
}

TEST(Pictures, OfTheErrorBudgetShowABarForEachPartAndTheTotal) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  SavedRun run = made_up_run();
  auto& one = run.summary["cases"][0];
  one["budget"][0]["parts"][0]["l1"] = 0.04321;
  one["budget"][0]["total"] = 0.01234;
  ASSERT_TRUE(draw_pictures(directory.path(), run.summary, run.marginals).empty());
  const fs::path figures = directory.path() / "figures";
  EXPECT_TRUE(contents(figures / "case1-budget.png").starts_with("\x89PNG\r\n\x1a\n"));
  const std::string svg = contents(figures / "case1-budget.svg");
  for (const char* text : {"gaussian-n4 *", "closure + impact", "truncation", "sampling", "total",
                           "* no admissible density", "case1: c = 0.1"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
  const std::string script = contents(figures / "case1-budget.gp");
  // epc-gaussian-n2 is the first of the groups; its bars share 0.8 of the unit.
  EXPECT_TRUE(contains(script, "$y_l1_0 << EOD\n0.7")) << script;
  EXPECT_TRUE(contains(script, " 0.04321 ")) << script;
  EXPECT_TRUE(contains(script, "$y_l1_total << EOD\n0.6000 0.01234 0.8000\n")) << script;

  one["budget"] = nlohmann::ordered_json::array();
  draw_pictures(directory.path(), run.summary, run.marginals);
  EXPECT_FALSE(fs::exists(figures / "case1-budget.png"));  // of the run before
  EXPECT_TRUE(fs::exists(figures / "case1.png"));
}

TEST(Pictures, WithoutGnuplotAreOneWarningAndLeaveTheScripts) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run();
  const auto warnings =
      draw_pictures(directory.path(), run.summary, run.marginals, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings.front(), "'no-such-gnuplot' was not found")) << warnings.front();
  EXPECT_TRUE(fs::exists(directory.path() / "figures" / "case1.gp"));
  EXPECT_FALSE(fs::exists(directory.path() / "figures" / "case1.png"));
}

TEST(Pictures, OfAGnuplotThatFailsAreAWarningAndNoFile) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run();
  for (const char* broken : {"false", "true"}) {  // an exit code; no picture in spite of success
    const auto warnings = draw_pictures(directory.path(), run.summary, run.marginals, broken);
    ASSERT_EQ(warnings.size(), 4u);
    EXPECT_TRUE(contains(warnings.front(), "case1.png was not drawn")) << warnings.front();
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& file : fs::directory_iterator(directory.path() / "figures")) {
      ++files;
    }
    EXPECT_EQ(files, 2u);  // the scripts
  }
}

TEST(Pictures, OfAGnuplotThatStopsHalfWayAreNotKept) {
  const tests::TemporaryDirectory directory;
  const fs::path stops = directory.path() / "stops";
  std::ofstream(stops) << "#!/bin/sh\n"
                          "target=${2#*target=\\'}\n"
                          "echo half > \"${target%%\\'*}\"\n"
                          "echo 'line 7: undefined function' >&2\n"
                          "exit 3\n";
  fs::permissions(stops, fs::perms::owner_all);
  const SavedRun run = made_up_run();
  const auto warnings = draw_pictures(directory.path(), run.summary, run.marginals, stops.string());
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_TRUE(contains(warnings.front(), "code 3 (line 7: undefined function)"))
      << warnings.front();
  EXPECT_FALSE(fs::exists(directory.path() / "figures" / "case1.png"));
}

TEST(Pictures, ACaseWithoutADensityIsAWarning) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run();
  const auto warnings = draw_pictures(directory.path(), run.summary, {});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings.front(), "no picture of case1"));
}

}  // namespace
}  // namespace fpkcheck::compare
