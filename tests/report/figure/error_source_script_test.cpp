#include "report/figure/error_source_script.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "case_with_sources.hpp"
#include "report/figure/drawing.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;

TEST(ErrorSourceScript, HasAMapForEachMomentOfTheClosestClosureAndTheEquation) {
  const auto case_result = tests::case_with_sources();
  ASSERT_TRUE(has_error_sources(case_result));
  const std::string script = error_source_script(case_result, "stem");
  // Letters follow the panels row by row; each density has a column.
  EXPECT_TRUE(contains(script, "(a) E[{/:Italic y}²] of epc-gaussian-n6: +1.0 × 10^{−3}"))
      << script;
  EXPECT_TRUE(contains(script, "(c) E[{/:Italic y}''²] of epc-gaussian-n6: −2.0 × 10^{−3}"));
  EXPECT_TRUE(contains(script, "(d) E[{/:Italic y}''²] of fd-kf: −2.0 × 10^{−6}"));
  EXPECT_TRUE(contains(script, "plot $y2_0 matrix"));
  EXPECT_TRUE(contains(script, "plot $v2_1 matrix"));
  EXPECT_FALSE(has_error_sources(tests::made_up_case()));
}

// Values and positions of the tics of the colour bar of each panel.
std::vector<std::vector<std::pair<double, double>>> colour_tics(const std::string& script) {
  std::vector<std::vector<std::pair<double, double>>> panels;
  const std::regex tic("'((?:−)?)([0-9]+)'(?:, '[^']*'\\))? (-?[0-9.]+)");
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("set cbtics (")) continue;
    auto& tics = panels.emplace_back();
    for (auto at = std::sregex_iterator(line.begin(), line.end(), tic);
         at != std::sregex_iterator(); ++at) {
      const double value = std::stod((*at)[2]);
      tics.emplace_back((*at)[1].length() > 0 ? -value : value, std::stod((*at)[3]));
    }
  }
  return panels;
}

TEST(ErrorSourceScript, PlacesEqualStepsByTheSignedRoot) {
  const std::string script = error_source_script(tests::case_with_sources(), "stem");
  const auto panels = colour_tics(script);
  ASSERT_EQ(panels.size(), 4u) << script;
  for (const auto& tics : panels) {
    ASSERT_GE(tics.size(), 5u);
    const double step = tics[1].first - tics[0].first;
    const auto [last, top] = tics.back();
    EXPECT_LE(top, 1);
    EXPECT_GT(top * top * (1 + step / last), 1);  // a further step would exceed the bar
    for (std::size_t k = 0; k < tics.size(); ++k) {
      const auto [value, place] = tics[k];
      EXPECT_NEAR(value - tics.front().first, static_cast<double>(k) * step, 1e-9);
      EXPECT_NEAR(place, std::copysign(top * std::sqrt(std::abs(value / last)), value), 2e-4);
    }
  }
  std::size_t labels = 0;
  const std::string label = "set cblabel say('error per area";
  for (auto at = script.find(label); at != std::string::npos; at = script.find(label, at + 1)) {
    ++labels;
  }
  EXPECT_EQ(labels, 4u);
}

// A summary from an untrusted source must not inject commands.
TEST(ErrorSourceScript, RunsNoCommandOfAnId) {
  auto case_result = tests::case_with_sources();
  const std::string id = "x`touch PWNED`\"_'";
  for (auto& s : case_result.solutions) {
    if (s.id() == "fd-kf") s.identity.id = id;
  }
  for (auto& own : case_result.moment_error_estimates)
    own.solution = own.solution == "fd-kf" ? id : own.solution;
  for (auto& s : case_result.error_sources) s.solution = s.solution == "fd-kf" ? id : s.solution;
  const std::string script = error_source_script(case_result, "stem");
  EXPECT_TRUE(contains(
      script, "set title say('(b) E[{/:Italic y}²] of x`touch PWNED`\"\\_\'\': +1.0 × 10^{−6}', "))
      << script.substr(0, 400);
}

TEST(ErrorSourceScript, IsDrawn) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "no gnuplot";
  const tests::TemporaryDirectory directory;
  const auto warnings =
      write_pictures(directory.path(), "stem",
                     error_source_script(tests::case_with_sources(), "stem"), {}, "gnuplot");
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "stem.png"));
}

}  // namespace
}  // namespace fpkcheck::report
