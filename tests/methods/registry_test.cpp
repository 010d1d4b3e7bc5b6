#include "methods/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/input_error.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::methods {
namespace {

std::vector<std::string> ids(const std::string& list) {
  std::vector<std::string> result;
  for (const auto& method : builtin_registry().methods_selected_by_list(list, {}))
    result.push_back(method.id());
  return result;
}

using Ids = std::vector<std::string>;

TEST(SolverRegistry, FamiliesSelectTheirMembersByIncreasingTrust) {
  EXPECT_EQ(ids("mcs,fd,epc"),
            (Ids{"epc-gaussian-n2", "epc-gaussian-n4", "epc-gaussian-n6", "epc-gaussian-n8",
                 "epc-moment-n4", "epc-moment-n8", "epc-moment-n12", "epc-polar-n4", "epc-polar-n6",
                 "epc-polar-n8", "fd-white", "fd-km4-delta", "fd-km4", "fd-kf", "mcs"}));
}

TEST(SolverRegistry, ItemsAreSelectedOnceInTheOrderOfTrust) {
  EXPECT_EQ(ids("epc-gaussian-n12,fd-kf,epc-gaussian-n2,fd-kf,fd-km4,epc-gaussian-n02"),
            (Ids{"epc-gaussian-n2", "epc-gaussian-n12", "fd-km4", "fd-kf"}));
}

TEST(SolverRegistry, AFormulationSelectsItsOrders) {
  EXPECT_EQ(ids("epc-moment"), (Ids{"epc-moment-n4", "epc-moment-n8", "epc-moment-n12"}));
  EXPECT_EQ(
      ids("epc-moment-cut-n6,epc-gaussian-white-n4,epc-moment-white-n6,epc-moment-n6"),
      (Ids{"epc-gaussian-white-n4", "epc-moment-cut-n6", "epc-moment-n6", "epc-moment-white-n6"}));
}

TEST(SolverRegistry, UnknownMethodsAreRefused) {
  for (const std::string bad :
       {"", "fdm", "fd-kf2", "epc-gaussian-n", "epc-gaussian-n6x", "epc,,mcs", "mcs2"}) {
    EXPECT_THROW(ids(bad), InputError) << bad;
  }
  EXPECT_THROW(ids("epc-gaussian-n7"), InputError);    // odd order
  EXPECT_THROW(ids("epc-gaussian-n400"), InputError);  // order out of range
  EXPECT_THROW(ids("epc-moment-km4-n6"), InputError);  // km4 is the equation of no process
}

TEST(SolverRegistry, SolutionsHaveTheIdentityOfTheirMethod) {
  const auto problem = tests::paper_case(1);
  const auto axes = compare::comparison_bins(problem);
  for (const auto& method : builtin_registry().methods_selected_by_list(
           "epc-gaussian-n2,epc-gaussian-white-n4,epc-moment-n4,epc-moment-cut-n2,fd-white,mcs",
           {{"time", 5000.0}})) {
    const auto solution = method.solve(problem, {axes, {}});
    EXPECT_EQ(solution.id(), method.id());
    EXPECT_EQ(solution.identity.equation, method.identity.equation) << method.id();
    EXPECT_EQ(solution.identity.impact, method.identity.impact) << method.id();
    EXPECT_EQ(solution.identity.order, method.identity.order) << method.id();
    EXPECT_EQ(solution.identity.formulation, method.identity.formulation) << method.id();
    EXPECT_TRUE(solution.density.has_value()) << method.id();
    EXPECT_FALSE(solution.metrics.empty()) << method.id();
  }
}

TEST(SolverRegistry, SimulationUsesTheComparisonAxes) {
  const auto problem = tests::paper_case(1);
  const auto axes = compare::comparison_bins(problem);
  const auto solution =
      builtin_registry().find_method_by_id("mcs", {{"time", 5000.0}})->solve(problem, {axes, {}});
  const auto m = marginal(solution, transform::StateVariable::y, axes.y_edges);
  EXPECT_FALSE(m.lower.empty());  // estimated by the simulation, with intervals
}

TEST(SolverRegistry, EveryMethodHasAMeaningAndADistinctStyle) {
  std::set<std::pair<std::string, std::string>> looks;  // colour and dash
  const auto methods = builtin_registry().methods_selected_by_list("epc,fd,mcs", {});
  for (const auto& method : methods) {
    const auto& who = method.identity;
    EXPECT_FALSE(who.family.empty()) << who.id;
    EXPECT_FALSE(who.meaning.empty()) << who.id;
    EXPECT_TRUE(who.equation && who.impact) << who.id;
    EXPECT_NE(who.role, transform::SolutionRole::external) << who.id;
    const std::string points = who.plot_style.as_points ? "points" : "";
    looks.emplace(who.plot_style.colour + points,
                  who.plot_style.dash + std::to_string(who.plot_style.width));
  }
  EXPECT_EQ(looks.size(), methods.size());
}

TEST(SolverRegistry, OverridesReplaceExistingOptions) {
  const base::Values given{{"time", 123.0}, {"seed", std::int64_t{9}}};
  const auto option = [&](const Method& method, const std::string& name) {
    const auto found = std::ranges::find(method.options, name, &base::NamedParameterValue::name);
    return found == method.options.end() ? std::string("none") : base::value_as_text(found->value);
  };
  EXPECT_EQ(option(*builtin_registry().find_method_by_id("mcs", given), "time"), "123");
  EXPECT_EQ(option(*builtin_registry().find_method_by_id("mcs", given), "seed"), "9");
  EXPECT_EQ(option(*builtin_registry().find_method_by_id("fd-kf", given), "time"), "none");
  EXPECT_EQ(option(*builtin_registry().find_method_by_id("fd-kf"), "error_estimate"), "true");
}

TEST(SolverRegistry, FindsTheMethodOfASolution) {
  const SolverRegistry registry = builtin_registry();
  for (const auto& method :
       registry.methods_selected_by_list("epc-moment-n8,epc-gaussian-kf-n4,fd,mcs", {})) {
    transform::Solution saved{.identity = {.id = method.id(), .method = method.identity.method},
                              .options = method.options};
    const auto again = registry.method_for_solution(saved, {});
    ASSERT_TRUE(again) << method.id();
    EXPECT_EQ(again->identity, method.identity);
    EXPECT_EQ(again->options, method.options);
    saved.identity.id += "x";
    EXPECT_THROW(registry.method_for_solution(saved, {}), InputError);
    saved.identity = {.id = method.id(), .method = "magic"};
    EXPECT_THROW(registry.method_for_solution(saved, {}), InputError);
    saved.identity.method = "file";
    EXPECT_FALSE(registry.method_for_solution(saved, {}));
  }
}

TEST(SolverRegistry, AnnotatesTheSolutionsOfAnOlderRun) {
  const SolverRegistry registry = builtin_registry();
  results::Run run{{}, {{tests::paper_case(1), {}, {}, {}, {}, {}, {}}}};
  run.cases[0].solutions = {{.identity = {.id = "epc-moment-n8", .method = "epc"}},
                            {.identity = {.id = "stranger", .method = "magic"}}};
  registry.set_missing_identity_fields_of_run(run);
  EXPECT_EQ(run.cases[0].solutions[0].identity.family, "epc-moment");
  EXPECT_EQ(run.cases[0].solutions[0].identity.role, transform::SolutionRole::closure);
  EXPECT_EQ(run.cases[0].solutions[1].identity.family, "");
}

TEST(SolverRegistry, RefusesDuplicateNames) {
  SolverRegistry registry = builtin_registry();
  EXPECT_THROW(registry.add_solver(epc_solver()), std::logic_error);
  Solver same_families = epc_solver();
  same_families.name = "another";
  EXPECT_THROW(registry.add_solver(same_families), std::logic_error);
  Solver same_name = epc_solver();
  same_name.families.clear();
  EXPECT_THROW(registry.add_solver(same_name), std::logic_error);
}

}  // namespace
}  // namespace fpkcheck::methods
