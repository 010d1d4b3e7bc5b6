#include "workflows/sweep/plan/plan_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/input_error.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::sweep {
namespace {

class PlanFile : public testing::Test {
 protected:
  std::string file(const std::string& text) {
    const auto path = directory_.path() / "mine.ini";
    std::ofstream(path) << text;
    return path.string();
  }
  std::string complaint(const std::string& text) {
    try {
      read_plan(file(text), {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  tests::TemporaryDirectory directory_;
};

constexpr const char* kCase =
    "[system]\ndamping = 0.2\nstiffness = 1\ncubic = 0\nrestitution = 0.9\n"
    "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.1\n";

TEST_F(PlanFile, HasACaseAndVariedKeys) {
  const auto plan = read_plan(
      file(std::string("[sweep]\nmethods = epc,fd-kf ; all of them\ndesign = sobol\npoints = 7\n"
                       "accuracy = 0.1\n[vary]\nsystem.cubic = 0:1\nimpulse.rate=log:1:2\n") +
           kCase),
      {"system.damping=0.3"});
  EXPECT_EQ(plan.base.name, "mine");
  EXPECT_EQ(plan.base.system.coefficients().damping, 0.3);
  ASSERT_EQ(plan.axes.size(), 2);
  EXPECT_EQ(plan.axes[1].text(), "impulse.rate = log:1:2");
  EXPECT_EQ(plan.design, PlanDesign::sobol);
  EXPECT_EQ(plan.points, 7);
  EXPECT_EQ(plan.methods, "epc,fd-kf");
  ASSERT_EQ(plan.options.size(), 1);
  EXPECT_EQ(plan.options[0].key, "accuracy");
}

TEST_F(PlanFile, MayNameItsCaseOrBeACaseAlone) {
  EXPECT_EQ(read_plan(file("[sweep]\ncase = case3\n[vary]\nsystem.cubic = 1,2\n"), {}).base.name,
            "case3");
  EXPECT_TRUE(read_plan(file(kCase), {}).axes.empty());
  EXPECT_EQ(read_plan("case2", {}).base.name, "case2");
}

TEST_F(PlanFile, ReportsInvalidInputWithItsLine) {
  EXPECT_NE(complaint("[sweep]\ncase = case1\n[system]\ndamping = 1\n").find(":2: a case beside"),
            std::string::npos);
  EXPECT_NE(complaint("[sweep]\ncase = case1\ncase = case2\n").find(":3: key 'sweep.case'"),
            std::string::npos);
  EXPECT_NE(complaint("[sweep]\ncase = case1\ndesign = all\n").find(":3: design 'all'"),
            std::string::npos);
  EXPECT_NE(complaint("[sweep]\ncase = case1\npoints = -1\n").find(":3: points '-1'"),
            std::string::npos);
  EXPECT_NE(complaint("[sweep]\ncase = case1\n[vary]\nsystem.colour = 1\n").find("system.colour"),
            std::string::npos);
  EXPECT_NE(complaint("[sweep]\n[vary]\nsystem.cubic = 1,2\n[system]\ndamping = 1\n")
                .find("'system.stiffness' is missing"),
            std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::sweep
