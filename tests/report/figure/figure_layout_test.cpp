#include "report/figure/figure_layout.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "paper_cases.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/run_gnuplot.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;

TEST(WallFrame, TitlesAFigureWithTheNameAndTheParameters) {
  auto problem = tests::paper_case(1);
  problem.name = "it's a_b";
  const auto title =
      make_figure_title(problem_title_parts(problem), {.width = 1500, .height = 900});
  EXPECT_TRUE(title.command.starts_with(
      "set multiplot title say('it''s a\\_b: c = 0.1, k = 1, μ = 0.1, r = 0.98;"))
      << title.command;
}

TEST(WallFrame, BreaksATitleThatIsLongerThanTheFigureIsWide) {
  const auto problem = tests::paper_case(1);
  const auto wide = make_figure_title(problem_title_parts(problem), {.width = 1500, .height = 900});
  const auto narrow =
      make_figure_title(problem_title_parts(problem),
                        {.width = 471, .height = 900, .medium = FigureWidth::one_column});
  EXPECT_EQ(wide.command.find("\"\\n\""), std::string::npos) << wide.command;
  EXPECT_NE(narrow.command.find(";').\"\\n\".say('gaussian impulses"), std::string::npos)
      << narrow.command;
  EXPECT_GT(narrow.height, wide.height);
}

TEST(WallFrame, SizesBothFormats) {
  const std::string text = gnuplot_output_commands("stem", {.width = 12, .height = 34});
  EXPECT_NE(text.find("set terminal svg size 12,34 "), std::string::npos) << text;
  EXPECT_NE(text.find("set terminal pngcairo size 12,34 "), std::string::npos) << text;
  EXPECT_NE(text.find("target = 'stem'.'.'.format"), std::string::npos) << text;
}

TEST(WallFrame, DrawsMinusSignsNotHyphens) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "no gnuplot";
  const tests::TemporaryDirectory directory;
  const std::string script = gnuplot_output_commands("stem", {.width = 400, .height = 300}) +
                             "unset key\nplot [-2:2] [-2:2] x\n";
  const auto warnings = write_script_and_draw(directory.path(), "stem", script,
                                              {.formats = {FigureFormat::svg}}, "gnuplot");
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const std::string svg = tests::contents(directory.path() / "stem.svg");
  EXPECT_TRUE(tests::contains(svg, ">−2</tspan>"));
  EXPECT_FALSE(tests::contains(svg, ">-2</tspan>"));
}

// 85 mm are 241 points, or 1004 pixels at 300 dots per inch; letters have 7.5 points.
TEST(WallFrame, DrawsForPrintInItsSize) {
  constexpr auto kColumn = FigureWidth::one_column;
  EXPECT_EQ(layout_width_in_pixels(kColumn, 1500), 471);
  EXPECT_EQ(layout_width_in_pixels(FigureWidth::two_columns, 1500), 942);
  EXPECT_EQ(layout_width_in_pixels(FigureWidth::screen, 1500), 1500);
  const std::string text =
      gnuplot_output_commands("stem", {.width = 471, .height = 200, .medium = kColumn});
  EXPECT_NE(text.find("pngcairo size 1004,426 "), std::string::npos) << text;
  EXPECT_NE(text.find("pdfcairo size 3.3452,1.4205 "), std::string::npos) << text;
  EXPECT_NE(text.find("font ',7.5'"), std::string::npos) << text;
}

namespace fs = std::filesystem;
std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

FigureLegend legend_of(int entries, std::size_t letters) {
  FigureLegend legend{{}, 5};
  for (int k = 0; k < entries; ++k) {
    legend.entries.push_back({"NaN with lines", std::to_string(1000 + k)});
    legend.entries.back().label.resize(letters, 'm');
  }
  return legend;
}

/// The number of entries shown by gnuplot.
std::size_t shown(const FigureLegend& legend, const fs::path& directory) {
  const FigureSize size{.width = 1500, .height = 500 + legend_height(legend, 1500)};
  const fs::path script = directory / "stem.gp", svg = directory / "stem.svg";
  std::ofstream(script) << gnuplot_output_commands("stem", size) << "set multiplot\n"
                        << legend_strip_commands(legend, size) << "unset multiplot\nunset output\n";
  const auto outcome =
      run_gnuplot("gnuplot", {"format='svg'", "target=" + quote_for_gnuplot(svg.string())}, script);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.message;
  const std::string text = tests::contents(svg);
  return count(text, "<text>");
}

TEST(LegendStrip, ShowsAllEntriesHoweverManyAndLong) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  for (const int entries : {1, 4, 5, 9, 13, 17, 26}) {
    for (const std::size_t letters : {5u, 17u, 31u, 45u}) {
      EXPECT_EQ(shown(legend_of(entries, letters), directory.path()), entries)
          << entries << " of " << letters << " letters";
    }
  }
}

TEST(LegendStrip, TakesMoreRoomForMoreAndLongerEntries) {
  EXPECT_LT(legend_height(legend_of(4, 10), 1500), legend_height(legend_of(5, 10), 1500));
  EXPECT_LT(legend_height(legend_of(4, 10), 1500), legend_height(legend_of(4, 40), 1500));
  EXPECT_LT(legend_height(legend_of(4, 10), 1500), legend_height(legend_of(4, 10), 600));
  // Entries longer than the width of the figure: a single column.
  EXPECT_EQ(legend_height(legend_of(4, 500), 1500), legend_height(legend_of(4, 1000), 1500));
}

TEST(LegendStrip, ShowsLabelsLiterally) {
  const FigureLegend legend{{{"NaN with lines", "a_b's"}}, 2};
  EXPECT_TRUE(contains(legend_strip_commands(legend, {.width = 1500, .height = 900}),
                       "plot [0:1] [0:1] NaN with lines title 'a\\_b''s'\n"));
}

}  // namespace
}  // namespace fpkcheck::report
