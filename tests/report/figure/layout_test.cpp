#include "report/figure/layout.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "report/figure/gnuplot.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;
using tests::contains;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Legend legend_of(int entries, std::size_t letters) {
  Legend legend{{}, 5};
  for (int k = 0; k < entries; ++k) {
    legend.entries.push_back({"NaN with lines", std::to_string(1000 + k)});
    legend.entries.back().label.resize(letters, 'm');
  }
  return legend;
}

/// The number of entries shown by gnuplot.
std::size_t shown(const Legend& legend, const fs::path& directory) {
  const FigureSize size{.width = 1500, .height = 500 + legend_height(legend, 1500)};
  const fs::path script = directory / "stem.gp", svg = directory / "stem.svg";
  std::ofstream(script) << gnuplot_output_commands("stem", size) << "set multiplot\n"
                        << legend_strip_commands(legend, size) << "unset multiplot\nunset output\n";
  const auto outcome =
      run_gnuplot("gnuplot", {"format='svg'", "target=" + gnuplot_string(svg.string())}, script);
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
  const Legend legend{{{"NaN with lines", "a_b's"}}, 2};
  EXPECT_TRUE(contains(legend_strip_commands(legend, {.width = 1500, .height = 900}),
                       "plot [0:1] [0:1] NaN with lines title 'a\\_b''s'\n"));
}

}  // namespace
}  // namespace fpkcheck::report
