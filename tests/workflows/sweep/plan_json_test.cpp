#include "workflows/sweep/plan/plan_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_sweep.hpp"

namespace fpkcheck::sweep {
namespace {

std::string difference(const Plan& before, const Plan& now) {
  return plan_difference(plan_json(before), plan_json(now));
}

TEST(PlanJson, IsReadBackUnchanged) {
  const Plan plan = tests::plan_of({parse_axis("impulse.law", "gaussian,laplace", "x"),
                                    parse_axis("system.cubic", "log:1:100:3", "x")});
  const auto json = results::Json::parse(plan_json(plan).dump());
  const Plan again = plan_from_json(json, methods::builtin_registry());
  EXPECT_EQ(again.points, plan.points);
  EXPECT_EQ(difference(plan, again), "");
  EXPECT_EQ(again.methods[1].id(), "fd-kf");
}

TEST(PlanJson, ReportsTheFirstDifference) {
  const Plan plan = tests::small_plan();
  const auto with = [&](auto change) {
    Plan other = tests::small_plan();
    change(other);
    return difference(plan, other);
  };
  EXPECT_EQ(with([](Plan& p) { p.marginals = true; }), "marginals: false then, true now");
  EXPECT_EQ(with([](Plan& p) { p.closure_errors = ClosureErrorSource::residuals; }),
            "closure_errors: \"reference\" then, \"residuals\" now");
  EXPECT_NE(with([](Plan& p) { p.axes[0].values[1] = 3.0; }).find("impulse.rate"),
            std::string::npos);
  EXPECT_NE(with([](Plan& p) { p.methods.pop_back(); }).find("fd-kf"), std::string::npos);
  EXPECT_NE(with([](Plan& p) {
              p.base = tests::make_problem({.damping = 0.2});
            }).find("case system damping: 0.1 then, 0.2 now"),
            std::string::npos);
  const std::string option = with([](Plan& p) {
    p.methods =
        methods::builtin_registry().select_methods("epc-gaussian-n2,fd-kf", {{"accuracy", 0.5}});
  });
  EXPECT_NE(option.find("\"epc-gaussian-n2\" options accuracy: 0.02 then, 0.5 now"),
            std::string::npos)
      << option;
}

}  // namespace
}  // namespace fpkcheck::sweep
