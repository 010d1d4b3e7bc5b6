#include "report/figure/sources_script.hpp"

#include <gtest/gtest.h>

#include "report/figure/drawing.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"
#include "with_sources.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;

TEST(SourcesScript, HasAMapForEachMomentOfTheClosestClosureAndTheEquation) {
  const auto one = tests::case_with_sources();
  ASSERT_TRUE(has_sources(one));
  const std::string script = sources_script(one, "stem");
  EXPECT_TRUE(contains(script, "E[{/:Italic y}²] of epc-gaussian-n6: +1.0e-03")) << script;
  EXPECT_TRUE(contains(script, "E[{/:Italic y}''²] of epc-gaussian-n6: -2.0e-03"));
  EXPECT_TRUE(contains(script, "E[{/:Italic y}''²] of fd-kf: -2.0e-06"));
  EXPECT_TRUE(contains(script, "plot $y2_0 matrix"));
  EXPECT_TRUE(contains(script, "plot $v2_1 matrix"));
  EXPECT_FALSE(has_sources(tests::made_up_case()));
}

// A summary may come from anybody.
TEST(SourcesScript, AnIdRunsNothing) {
  auto one = tests::case_with_sources();
  const std::string id = "x`touch PWNED`\"_'";
  for (auto& s : one.solutions) {
    if (s.id() == "fd-kf") s.identity.id = id;
  }
  for (auto& own : one.own_errors) own.solution = own.solution == "fd-kf" ? id : own.solution;
  for (auto& s : one.error_sources) s.solution = s.solution == "fd-kf" ? id : s.solution;
  const std::string script = sources_script(one, "stem");
  EXPECT_TRUE(
      contains(script, "set title say('E[{/:Italic y}²] of x`touch PWNED`\"\\_\'\': +1.0e-06', "))
      << script.substr(0, 400);
}

TEST(SourcesScript, IsDrawn) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "no gnuplot";
  const tests::TemporaryDirectory directory;
  const auto warnings = write_pictures(
      directory.path(), "stem", sources_script(tests::case_with_sources(), "stem"), {}, "gnuplot");
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "stem.png"));
}

}  // namespace
}  // namespace fpkcheck::report
