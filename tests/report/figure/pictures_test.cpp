#include "report/figure/case_figures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "modified_case.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;
using tests::gnuplot_exists;
using tests::made_up_case;
using tests::made_up_run;

const FigureOptions kBothFormats{.formats = {FigureFormat::png, FigureFormat::svg}};
const FigureOptions kSvg{.formats = {FigureFormat::svg}};
const FigureOptions kAllOfBoth{.formats = kBothFormats.formats, .curves = {"all"}};

TEST(Pictures, AreAPngAndAnSvg) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings =
      draw_pictures_of_cases(directory.path(), made_up_run("it's a_{case}"), kBothFormats);
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
  for (const char* text : {"it's a_{case}: c = 0.1", "(a) displacement",
                           "(d) velocity, logarithmic", "(f) velocity, difference from mcs"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
}

/// The synthetic case with additional closures.
results::CaseResult with_closures(int count) {
  auto problem = tests::paper_case(1);
  problem.name = "case1";
  const auto axes = compare::comparison_bins(problem);
  auto solutions = tests::made_up_solutions(axes);
  for (int k = 0; k < count; ++k) {
    auto more = solutions[0];
    more.identity = tests::closure_identity("moment-with-a-long-name", 10 + 2 * k);
    solutions.insert(solutions.begin() + 4, more);
  }
  return results::make_case_result(problem, axes, std::move(solutions));
}

class PictureLegend : public testing::TestWithParam<int> {};

TEST_P(PictureLegend, HasAnEntryForEveryCurveThatIsDrawn) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto case_result = with_closures(GetParam());
  ASSERT_TRUE(draw_pictures_of_cases(directory.path(),
                                     {results::current_program(""), {case_result}}, kAllOfBoth)
                  .empty());
  const std::string svg = contents(directory.path() / "figures" / "case1.svg");
  for (const auto& solution : case_result.solutions) {
    std::string label = solution.id();
    if (!solution.has_status_ok()) label += fmt::format(" ({})", name(solution.status));
    if (solution.identity.plot_style.as_points) label += ", with 95 % intervals";
    // The SVG contains hidden titles as comments.
    const bool shown = contains(svg, " >" + label + "</tspan></text>");
    EXPECT_EQ(shown,
              case_result.marginal_curve(solution.id(), transform::StateVariable::y) != nullptr)
        << label;
  }
}

INSTANTIATE_TEST_SUITE_P(Pictures, PictureLegend, testing::Values(0, 5, 18));

TEST(Pictures, TheScriptDrawsTheSameAgainByHand) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  draw_pictures_of_cases(directory.path(), made_up_run(), kBothFormats);
  const fs::path figures = directory.path() / "figures";
  const std::string first = contents(figures / "case1.svg");
  fs::remove(figures / "case1.svg");
  const std::string command =
      "cd '" + figures.string() + "' && gnuplot -e \"format='svg'\" case1.gp";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(contents(figures / "case1.svg"), first);
}

TEST(Pictures, OfTheErrorBudgetNameEveryPart) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  auto run = made_up_run();
  ASSERT_TRUE(draw_pictures_of_cases(directory.path(), run, kBothFormats).empty());
  const fs::path figures = directory.path() / "figures";
  EXPECT_TRUE(contents(figures / "case1-budget.png").starts_with("\x89PNG\r\n\x1a\n"));
  const std::string svg = contents(figures / "case1-budget.svg");
  for (const char* text : {"gaussian-n4 *", "closure + impact", "truncation",
                           "discretisation + sampling", "total", "* not ok", "case1: c = 0.1"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
  run.cases[0].budget.clear();
  draw_pictures_of_cases(directory.path(), run);
  EXPECT_FALSE(fs::exists(figures / "case1-budget.png"));  // from the earlier run
  EXPECT_TRUE(fs::exists(figures / "case1.png"));
}

/// Changes the current directory; the destructor restores it.
class WorkingIn {
 public:
  explicit WorkingIn(const fs::path& directory) { fs::current_path(directory); }
  ~WorkingIn() { fs::current_path(before_); }

 private:
  fs::path before_ = fs::current_path();
};

// gnuplot runs a file name that begins with '<' or '|' as a command.
TEST(Pictures, RunNoCommandOfADirectoryName) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const WorkingIn working(directory.path());
  for (const std::string name : {"<touch PWNED;#", "|touch PWNED;#", "it's; system 'touch PWNED'",
                                 "`touch PWNED`", "$(touch PWNED)"}) {
    const auto warnings = draw_pictures_of_cases(name, made_up_run(), kSvg);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    EXPECT_TRUE(fs::exists(fs::path(name) / "figures" / "case1.svg")) << name;
  }
  for (const auto& entry : fs::recursive_directory_iterator(directory.path())) {
    EXPECT_NE(entry.path().filename(), "PWNED") << entry.path();
  }
}

TEST(Pictures, WithoutGnuplotAreOneWarningAndLeaveTheScripts) {
  const tests::TemporaryDirectory directory;
  const auto warnings =
      draw_pictures_of_cases(directory.path(), made_up_run(), {}, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings.front(), "'no-such-gnuplot' was not found")) << warnings.front();
  EXPECT_TRUE(fs::exists(directory.path() / "figures" / "case1.gp"));
  EXPECT_TRUE(fs::exists(directory.path() / "figures" / "case1-budget.gp"));
  EXPECT_FALSE(fs::exists(directory.path() / "figures" / "case1.png"));
}

TEST(Pictures, OfAGnuplotThatFailsAreAWarningAndNoFile) {
  const tests::TemporaryDirectory directory;
  for (const char* broken : {"false", "true"}) {  // exit code 1; exit code 0 without a picture
    const auto warnings =
        draw_pictures_of_cases(directory.path(), made_up_run(), kBothFormats, broken);
    ASSERT_EQ(warnings.size(), 6u);
    EXPECT_TRUE(contains(warnings.front(), "case1.png was not drawn")) << warnings.front();
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& file : fs::directory_iterator(directory.path() / "figures")) {
      ++files;
    }
    EXPECT_EQ(files, 3u);  // the scripts
  }
}

TEST(Pictures, ACaseWithoutADensityIsAWarning) {
  const tests::TemporaryDirectory directory;
  auto run = made_up_run();
  run.cases[0].curves.clear();
  const auto warnings = draw_pictures_of_cases(directory.path(), run);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings.front(), "no picture of case1"));
}

TEST(Pictures, ShowTheSelectedCurves) {
  const tests::TemporaryDirectory directory;
  const auto run = made_up_run();
  draw_pictures_of_cases(directory.path(), run, {.curves = {"epc", "mcs"}}, "no-such-gnuplot");
  const std::string script = contents(directory.path() / "figures" / "case1.gp");
  EXPECT_TRUE(contains(script, " title say('mcs"));
  EXPECT_TRUE(contains(script, " title 'epc-gaussian-n2"));
  EXPECT_FALSE(contains(script, " title 'fd-"));
}

// No hint at more curves after a selection by the user, or in print.
TEST(Pictures, StateTheNumberOfHiddenCurvesOnAScreen) {
  const auto run = made_up_run();
  const std::vector<std::string> chosen{"epc", "mcs"};
  for (const auto& curves : {std::vector<std::string>(), chosen}) {
    for (const auto width :
         {FigureWidth::screen, FigureWidth::two_columns, FigureWidth::one_column}) {
      const tests::TemporaryDirectory directory;
      draw_pictures_of_cases(directory.path(), run, {.width = width, .curves = curves},
                             "no-such-gnuplot");
      const std::string script = contents(directory.path() / "figures" / "case1.gp");
      ASSERT_TRUE(contains(script, " title say('mcs"));
      EXPECT_EQ(contains(script, "--curves"), curves.empty() && width == FigureWidth::screen);
    }
  }
}

TEST(Pictures, OfOnlyThisRunAreRemoved) {
  const tests::TemporaryDirectory directory;
  const fs::path figures = directory.path() / "figures";
  fs::create_directories(figures);
  for (const char* name : {"case1.png", "case1-budget.svg", "case1-order.png", "case1.gp",
                           "case1-tex.pdf", "case2.png"}) {
    std::ofstream(figures / name) << name;
  }
  remove_pictures_of_cases(directory.path(), made_up_run());
  ASSERT_EQ(std::distance(fs::directory_iterator(figures), {}), 1);
  EXPECT_TRUE(fs::exists(figures / "case2.png"));
}

}  // namespace
}  // namespace fpkcheck::report
