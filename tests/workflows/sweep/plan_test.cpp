#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/input_error.hpp"
#include "made_up_sweep.hpp"
#include "problem/case_file.hpp"
#include "temporary_directory.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_json.hpp"

namespace fpkcheck::sweep {
namespace {

using base::Value;

std::vector<double> numbers(const SweepAxis& axis) {
  std::vector<double> found;
  for (const auto& value : axis.values) found.push_back(std::get<double>(value));
  return found;
}

TEST(SweepAxis, RangesHaveBothEndsAndEvenSteps) {
  EXPECT_EQ(numbers(parse_sweep_axis("system.restitution", "0.5:0.99:8", "x")),
            (std::vector<double>{0.5, 0.57, 0.64, 0.71, 0.78, 0.85, 0.92, 0.99}));
  EXPECT_EQ(numbers(parse_sweep_axis("system.restitution", "1:0.8:3", "x")),
            (std::vector<double>{1, 0.9, 0.8}));
}

TEST(SweepAxis, LogarithmicRangesHaveEvenRatios) {
  EXPECT_EQ(numbers(parse_sweep_axis("impulse.rate", "log:0.01:100:5", "x")),
            (std::vector<double>{0.01, 0.1, 1, 10, 100}));
}

TEST(SweepAxis, ListsKeepTheirOrderAndMayHaveWords) {
  EXPECT_EQ(numbers(parse_sweep_axis("impulse.rate", "3, 1 ,2", "x")),
            (std::vector<double>{3, 1, 2}));
  EXPECT_EQ(parse_sweep_axis("impulse.law", "laplace,gaussian", "x").values,
            (std::vector<Value>{std::string("laplace"), std::string("gaussian")}));
}

TEST(SweepAxis, WithoutACountIsARangeWithoutValues) {
  const SweepAxis axis = parse_sweep_axis("impulse.rate", "log:0.1:10", "x");
  EXPECT_TRUE(axis.values.empty());
  EXPECT_NEAR(axis.value_at_fraction(0.5), 1, 1e-12);
  EXPECT_EQ(axis.axis_definition_text(), "impulse.rate = log:0.1:10");
}

const SweepAxis kRates = parse_sweep_axis("impulse.rate", "1,2", "x");
const SweepAxis kLosses = parse_sweep_axis("system.restitution", "0.8,0.9,1", "x");

TEST(PlanPoints, OfAProductTheLastAxisVariesFastest) {
  const SweepPlanPoints points =
      make_sweep_plan_points({kRates, kLosses}, SweepPlanDesign::product, 0);
  ASSERT_EQ(points.size(), 6);
  EXPECT_EQ(points[1], (std::vector<base::Value>{1.0, 0.9}));
  EXPECT_EQ(points[3], (std::vector<base::Value>{2.0, 0.8}));
}

TEST(PlanPoints, OfAListHaveTheKthValues) {
  const SweepAxis two = parse_sweep_axis("system.restitution", "0.8,0.9", "x");
  EXPECT_EQ(make_sweep_plan_points({kRates, two}, SweepPlanDesign::list, 0),
            (SweepPlanPoints{{1.0, 0.8}, {2.0, 0.9}}));
  EXPECT_THROW(make_sweep_plan_points({kRates, kLosses}, SweepPlanDesign::list, 0), InputError);
}

// Each sixteenth of each range gets the same number of points, unlike random points.
TEST(PlanPoints, OfASobolSequenceFillTheBoxEvenly) {
  const std::vector<SweepAxis> axes{parse_sweep_axis("impulse.rate", "log:0.1:10", "x"),
                                    parse_sweep_axis("system.restitution", "0.5:1", "x"),
                                    parse_sweep_axis("system.cubic", "1:2", "x")};
  const SweepPlanPoints points = make_sweep_plan_points(axes, SweepPlanDesign::sobol, 255);
  ASSERT_EQ(points.size(), 255);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    std::array<int, 16> counts{};
    for (const auto& point : points) {
      const double value = std::get<double>(point[a]);
      const double part = a == 0   ? (std::log10(value) + 1) / 2
                          : a == 1 ? (value - 0.5) / 0.5
                                   : value - 1;
      ASSERT_GT(part, 0);
      ASSERT_LT(part, 1);
      ++counts[static_cast<std::size_t>(part * 16 + 1e-9)];
    }
    EXPECT_EQ(std::ranges::max(counts), 16);
    EXPECT_EQ(std::ranges::min(counts), 15);  // without the corner
  }
}

TEST(SweepPlan, AProblemHasTheValuesOfItsPoint) {
  const SweepPlan plan = tests::small_plan();
  const auto problem = plan.problem_at_sweep_point(4);
  EXPECT_EQ(problem.impulses.arrival_rate(), 2);
  EXPECT_EQ(problem.system.coefficients().restitution, 0.9);
  EXPECT_EQ(problem.system.coefficients().cubic, plan.base.system.coefficients().cubic);
  EXPECT_EQ(problem.name, plan.base.name);
}

// A misspelt constant would solve the same problem at each point.
TEST(SweepPlan, VariesOnlyConstantsOfTheCase) {
  const auto base = problem::load_case("coulomb", {});
  require_known_constants(base, {parse_sweep_axis("parameters.mu", "0.1,0.2", "x"), kRates});
  EXPECT_THROW(require_known_constants(base, {parse_sweep_axis("parameters.mue", "0.1,0.2", "x")}),
               InputError);
}

class PlanFile : public testing::Test {
 protected:
  std::string file(const std::string& text) {
    const auto path = directory_.path() / "mine.ini";
    std::ofstream(path) << text;
    return path.string();
  }
  tests::TemporaryDirectory directory_;
};

constexpr const char* kCase =
    "[system]\ndamping = 0.2\nstiffness = 1\ncubic = 0\nrestitution = 0.9\n"
    "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.1\n";

TEST_F(PlanFile, HasACaseAndVariedKeys) {
  const auto plan = read_sweep_plan(
      file(std::string("[sweep]\nmethods = epc,fd-kf ; all of them\ndesign = sobol\npoints = 7\n"
                       "accuracy = 0.1\n[vary]\nsystem.cubic = 0:1\nimpulse.rate=log:1:2\n") +
           kCase),
      {"system.damping=0.3"});
  EXPECT_EQ(plan.base.name, "mine");
  EXPECT_EQ(plan.base.system.coefficients().damping, 0.3);
  ASSERT_EQ(plan.axes.size(), 2);
  EXPECT_EQ(plan.axes[1].axis_definition_text(), "impulse.rate = log:1:2");
  EXPECT_EQ(plan.design, SweepPlanDesign::sobol);
  EXPECT_EQ(plan.points, 7);
  EXPECT_EQ(plan.methods, "epc,fd-kf");
  ASSERT_EQ(plan.options.size(), 1);
  EXPECT_EQ(plan.options[0].key, "accuracy");
}

TEST_F(PlanFile, MayNameItsCaseOrBeACaseAlone) {
  EXPECT_EQ(
      read_sweep_plan(file("[sweep]\ncase = case3\n[vary]\nsystem.cubic = 1,2\n"), {}).base.name,
      "case3");
  EXPECT_TRUE(read_sweep_plan(file(kCase), {}).axes.empty());
  EXPECT_EQ(read_sweep_plan("case2", {}).base.name, "case2");
}

std::string difference(const SweepPlan& before, const SweepPlan& now) {
  return first_sweep_plan_difference(sweep_plan_json(before), sweep_plan_json(now));
}

TEST(PlanJson, IsReadBackUnchanged) {
  const SweepPlan plan = tests::plan_of({parse_sweep_axis("impulse.law", "gaussian,laplace", "x"),
                                         parse_sweep_axis("system.cubic", "log:1:100:3", "x")});
  const auto json = results::Json::parse(sweep_plan_json(plan).dump());
  const SweepPlan again = sweep_plan_from_json(json, methods::builtin_registry());
  EXPECT_EQ(again.points, plan.points);
  EXPECT_EQ(difference(plan, again), "");
  EXPECT_EQ(again.methods[1].id(), "fd-kf");
}

TEST(PlanJson, ReportsTheFirstDifference) {
  const SweepPlan plan = tests::small_plan();
  const auto with = [&](auto change) {
    SweepPlan other = tests::small_plan();
    change(other);
    return difference(plan, other);
  };
  EXPECT_EQ(with([](SweepPlan& p) { p.marginals = true; }), "/marginals: false then, true now");
  EXPECT_EQ(with([](SweepPlan& p) { p.slopes = true; }), "/slopes: nothing then, true now");
  EXPECT_EQ(with([](SweepPlan& p) { p.closure_errors = ClosureErrorSource::residuals; }),
            "/closure_errors: \"reference\" then, \"residuals\" now");
  EXPECT_TRUE(
      with([](SweepPlan& p) { p.axes[0].values[1] = 3.0; }).starts_with("/vary/0/values/1: "));
  EXPECT_TRUE(with([](SweepPlan& p) { p.methods.pop_back(); }).ends_with(" then, nothing now"));
  EXPECT_EQ(with([](SweepPlan& p) { p.base = tests::make_problem({.damping = 0.2}); }),
            "/case/system/damping: 0.1 then, 0.2 now");
  EXPECT_EQ(with([](SweepPlan& p) {
              p.methods = methods::builtin_registry().methods_selected_by_list(
                  "epc-gaussian-n2,fd-kf", {{"accuracy", 0.5}});
            }),
            "/methods/0/options/accuracy: 0.02 then, 0.5 now");
}

}  // namespace
}  // namespace fpkcheck::sweep
