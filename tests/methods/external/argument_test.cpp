#include "methods/external/external_argument.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "refusal.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::methods {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;

std::string refusal_of_argument(const std::string& text) {
  return tests::refusal([&] { parse_external_argument(text); });
}

TEST(ExternalArguments, SetTheEquationOfAFile) {
  const auto whole = parse_external_argument("a/mine.csv:own,equation=km4,impact=delta,order=6");
  EXPECT_EQ(whole.file, "a/mine.csv");
  EXPECT_EQ(whole.label, "own");
  EXPECT_EQ(whole.equation, DensityEquation::km4);
  EXPECT_EQ(whole.impact, ImpactCondition::delta);
  EXPECT_EQ(whole.order, 6);
  const auto bare = parse_external_argument("a/mine.csv,equation=kf");
  EXPECT_EQ(bare.label, "mine");
  EXPECT_FALSE(bare.has_label);
  EXPECT_EQ(bare.equation, DensityEquation::kf);
  EXPECT_FALSE(bare.impact);
  const auto run = parse_external_argument("summary.json:m8,solution=epc-moment-n8,case=case2");
  EXPECT_EQ(run.solution, "epc-moment-n8");
  EXPECT_EQ(run.case_name, "case2");
}

TEST(ExternalArguments, DoNotSplitExistingFileNames) {
  const tests::TemporaryDirectory directory;
  const auto file = (directory.path() / "a:b,order=3").string();
  std::ofstream(file) << "1";
  EXPECT_EQ(parse_external_argument(file).file, file);
  EXPECT_FALSE(parse_external_argument(file).order);
  const auto more = parse_external_argument(file + ":c,order=4");
  EXPECT_EQ(more.file, file);
  EXPECT_EQ(more.label, "c");
  EXPECT_EQ(more.order, 4);
}

TEST(ExternalArguments, AreRefusedIfInvalid) {
  EXPECT_EQ(refusal_of_argument("a.csv,equation=km5"),
            "--against: equation = 'km5' (must be one of white, km4, km4-pade, kf)");
  EXPECT_EQ(refusal_of_argument("a.csv,impact=soft"),
            "--against: impact = 'soft' (must be one of map, delta, exact)");
  EXPECT_EQ(refusal_of_argument("a.csv,impact=delta"),
            "--against: impact = delta lacks an equation; give both");
  EXPECT_EQ(refusal_of_argument("a.csv,order=0"),
            "--against: order = '0' (must be an integer, 1 .. 99)");
  EXPECT_EQ(
      refusal_of_argument("a.csv,colour=red"),
      "--against: unknown key 'colour'; use equation, impact, order, samples, role, solution or case");
}

}  // namespace
}  // namespace fpkcheck::methods
