#include "report/figure/run_gnuplot.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;

const FigureOptions kBoth{.formats = {FigureFormat::png, FigureFormat::svg}};

/// A shell script in place of gnuplot.
class Drawing : public testing::Test {
 protected:
  std::string gnuplot(const std::string& commands) {
    const fs::path program = directory_.path() / "gnuplot";
    std::ofstream(program) << "#!/bin/sh\ntarget=${3#*target=\\'}\ntarget=${target%%\\'*}\n"
                           << commands;
    fs::permissions(program, fs::perms::owner_all);
    return program.string();
  }
  tests::TemporaryDirectory directory_;
  fs::path figures_ = directory_.path() / "figures";
};

TEST_F(Drawing, LeavesBothPicturesAndTheirScript) {
  const auto warnings =
      write_script_and_draw(figures_, "stem", "plot x\n", kBoth, gnuplot("echo $3 > \"$target\""));
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(contents(figures_ / "stem.gp"), "plot x\n");
  EXPECT_TRUE(contains(contents(figures_ / "stem.png"), "format='png'"));
  EXPECT_TRUE(contains(contents(figures_ / "stem.svg"), "format='svg'"));
  std::ofstream(figures_ / "other.png") << "another's";
  remove_script_and_pictures(figures_, "stem");
  EXPECT_TRUE(fs::exists(figures_ / "other.png"));
  fs::remove(figures_ / "other.png");
  EXPECT_TRUE(fs::is_empty(figures_));
}

// gnuplot writes the name of the included graphics with the full path.
TEST_F(Drawing, OfLatexIncludesGraphicsByFileName) {
  fs::create_directories(figures_);
  std::ofstream(figures_ / "stem.pdf") << "the picture in another format";
  const auto warnings = write_script_and_draw(
      figures_, "stem", "plot x\n", {.formats = {FigureFormat::tex}},
      gnuplot("echo \"includegraphics{${target%.tex}}\" > \"$target\"; echo art > "
              "\"${target%.tex}.pdf\""));
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(contents(figures_ / "stem.tex"), "includegraphics{stem-tex.pdf}\n");
  EXPECT_EQ(contents(figures_ / "stem-tex.pdf"), "art\n");
  EXPECT_EQ(contents(figures_ / "stem.pdf"), "the picture in another format");
  remove_script_and_pictures(figures_, "stem");
  EXPECT_TRUE(fs::is_empty(figures_));
}

TEST_F(Drawing, OfAnSvgForPrintStatesItsWidth) {
  const FigureOptions column{.formats = {FigureFormat::svg}, .width = FigureWidth::one_column};
  write_script_and_draw(figures_, "stem", "plot x\n", column,
                        gnuplot("printf '<svg\\n width=\"400\" height=\"200\"\\n viewBox=\"0\">' > "
                                "\"$target\""));
  EXPECT_EQ(contents(figures_ / "stem.svg"),
            "<svg\n width=\"85mm\" height=\"42.50mm\"\n viewBox=\"0\">");
}

TEST_F(Drawing, ThatFailsIsAWarningForEachPictureAndLeavesTheEarlierOne) {
  fs::create_directories(figures_);
  std::ofstream(figures_ / "stem.png") << "earlier";
  const auto warnings = write_script_and_draw(
      figures_, "stem", "plot x\n", kBoth,
      gnuplot("echo half > \"$target\"\necho 'line 7: undefined function' >&2\nexit 3\n"));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(contains(warnings[0],
                       "stem.png was not drawn: gnuplot exited with code 3 (line 7: "
                       "undefined function)"))
      << warnings[0];
  EXPECT_TRUE(contains(warnings[1], "stem.svg was not drawn")) << warnings[1];
  EXPECT_EQ(contents(figures_ / "stem.png"), "earlier");
  EXPECT_FALSE(fs::exists(figures_ / "stem.svg"));
}

TEST_F(Drawing, WithoutGnuplotIsOneWarningWithACommand) {
  const auto warnings =
      write_script_and_draw(figures_, "stem", "plot x\n", kBoth, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings[0], "'no-such-gnuplot' was not found")) << warnings[0];
  EXPECT_TRUE(contains(warnings[0], "&& gnuplot stem.gp`")) << warnings[0];
  EXPECT_TRUE(fs::exists(figures_ / "stem.gp"));
  EXPECT_THROW(draw_picture("no-such-gnuplot", figures_ / "stem.gp", figures_ / "stem.png"),
               GnuplotNotFound);
}

}  // namespace
}  // namespace fpkcheck::report
