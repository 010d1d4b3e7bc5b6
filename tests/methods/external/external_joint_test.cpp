#include "methods/external/external_joint.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "epc/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/external/external_methods.hpp"
#include "methods/run_cases.hpp"
#include "refusal.hpp"
#include "results/joint_netcdf.hpp"
#include "results/netcdf/writer.hpp"
#include "results/run_json.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::methods {
namespace {

namespace fs = std::filesystem;
using problem::DensityEquation;
using problem::ImpactCondition;
using tests::contains;
using transform::StateVariable;
using transform::Status;

// A synthetic run with the paper's equation, and files of its densities.
class JointDensityFiles : public testing::Test {
 protected:
  JointDensityFiles() {
    const auto before = std::ranges::find(solutions_, "fd-km4", &transform::Solution::id);
    auto delta =
        tests::smooth_density({2.5, 0.05, 2.3, -0.02}, axes_.y_edges.back(), axes_.v_edges.back());
    solutions_.insert(before,
                      tests::solution(tests::identity("fd-km4-delta", "fd", DensityEquation::km4,
                                                      ImpactCondition::delta),
                                      delta));
  }

  const transform::Solution& solution(const std::string& id) const {
    return *transform::find_solution(solutions_, id);
  }
  double value(const std::string& id, double y, double v) const {
    return std::get<transform::SmoothDensity>(*solution(id).density).value(y, v);
  }
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  std::string points_of(const std::string& id, const std::string& name, int n = 100) const {
    std::ofstream out(path(name));
    out << "y,v,p\n";
    for (int i = 0; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        const double y = axes_.y_edges.back() * i / n, v = axes_.v_edges.back() * j / n;
        out << fmt::format("{},{},{}\n", y, v, value(id, y, v));
      }
    }
    return path(name);
  }

  results::CaseResult case_with(const std::vector<std::string>& arguments) const {
    std::vector<transform::Solution> all;
    for (const auto& method :
         external_density_methods_from_files(arguments, builtin_registry(), problem_.name)) {
      method.check ? method.check(problem_) : void();
      all.push_back(solve_with_method(method, problem_, {axes_, {}}));
    }
    all.insert(all.end(), solutions_.begin(), solutions_.end());
    return results::make_case_result(problem_, axes_, all);
  }

  std::string refusal(const std::vector<std::string>& arguments) const {
    return tests::refusal([&] { case_with(arguments); });
  }

  tests::TemporaryDirectory directory_;
  problem::Problem problem_ = tests::paper_case(1);
  compare::ComparisonBins axes_ = compare::comparison_bins(problem_);
  std::vector<transform::Solution> solutions_ = tests::made_up_solutions(axes_);
};

TEST_F(JointDensityFiles, WithAnEquationHaveABudget) {
  const auto file = points_of("fd-km4-delta", "mine.csv");
  const auto one = case_with({file + ":mine,equation=km4,impact=delta,order=6"});
  const auto& mine = one.solutions.front();
  EXPECT_EQ(mine.id(), "mine");
  EXPECT_EQ(mine.identity.role, transform::SolutionRole::closure);
  EXPECT_TRUE(transform::is_external(mine.identity));
  EXPECT_EQ(transform::equation_and_impact_text(mine.identity), "km4/delta");
  EXPECT_EQ(mine.identity.order, 6);
  EXPECT_EQ(mine.status, Status::ok) << mine.reason;
  EXPECT_NEAR(mine.moments.y2 / solution("fd-km4-delta").moments.y2, 1, 1e-4);
  EXPECT_NEAR(mine.moments.v2 / solution("fd-km4-delta").moments.v2, 1, 1e-4);
  for (const auto& row : one.budget) {
    if (row.solution != "mine") continue;
    const auto apart = [&](const char* a, const char* b) {
      return *one.l1_distance(a, b, row.variable);
    };
    EXPECT_LT(row.find_budget_part("closure")->l1, 2e-4);
    EXPECT_DOUBLE_EQ(row.find_budget_part("impact")->l1, apart("fd-km4-delta", "fd-km4"));
    EXPECT_DOUBLE_EQ(row.find_budget_part("truncation")->l1, apart("fd-km4", "fd-kf"));
    EXPECT_GT(row.find_budget_part("truncation")->l1, 1e-5);
    EXPECT_EQ(row.find_budget_part("closure")->to, "fd-km4-delta");
  }
  EXPECT_EQ(std::ranges::count(one.budget, "mine", &compare::ErrorBudgetRow::solution), 2);
}

TEST_F(JointDensityFiles, WithoutAnEquationHaveDistancesOnly) {
  const auto one = case_with({points_of("fd-kf", "mine.csv")});
  const auto& mine = one.solutions.front();
  EXPECT_EQ(mine.identity.role, transform::SolutionRole::external);
  EXPECT_TRUE(transform::is_external(mine.identity));
  EXPECT_EQ(transform::equation_and_impact_text(mine.identity), "given/-");
  EXPECT_LT(*one.l1_distance("mine", "fd-kf", StateVariable::y), 2e-4);
  EXPECT_LT(*one.l1_distance("mine", "fd-kf", StateVariable::ydot), 2e-4);
  EXPECT_EQ(std::ranges::count(one.budget, "mine", &compare::ErrorBudgetRow::solution), 0);
  EXPECT_EQ(transform::metric_text(mine.metrics, "files[0].form"), "joint points");
}

// The simulation's exact reflection and the impact map of an equation are equivalent. The budget
// has no part between them.
TEST_F(JointDensityFiles, WithExactImpactsHaveTheChainOfTheMap) {
  const auto one = case_with({points_of("fd-km4", "mine.csv") + ",equation=km4,impact=exact"});
  EXPECT_EQ(transform::equation_and_impact_text(one.solutions.front().identity), "km4/exact");
  EXPECT_EQ(one.budget.front().solution, "mine");
  EXPECT_EQ(one.budget.front().find_budget_part("impact"), nullptr);
  EXPECT_EQ(one.budget.front().find_budget_part("closure")->to, "fd-km4");
}

TEST_F(JointDensityFiles, OfARunReproduceItsDensities) {
  const results::Run run{results::current_program("fpkcheck run"), {case_with({})}};
  std::ofstream(path("joint.nc"), std::ios::binary) << results::joint_netcdf_bytes(run);
  const std::string file = path("joint.nc");
  const auto one = case_with({file + ":a,solution=fd-kf", file + ",solution=fd-km4-delta"});
  EXPECT_EQ(one.solutions[0].id(), "a");
  EXPECT_EQ(one.solutions[1].id(), "given-fd-km4-delta");
  EXPECT_EQ(transform::equation_and_impact_text(one.solutions[1].identity), "km4/delta");
  EXPECT_LT(*one.l1_distance("a", "fd-kf", StateVariable::y), 2e-5);
  EXPECT_LT(*one.l1_distance("a", "fd-kf", StateVariable::ydot), 2e-5);
  EXPECT_LT(*one.l1_distance("given-fd-km4-delta", "fd-km4-delta", StateVariable::y), 2e-5);
  EXPECT_TRUE(contains(refusal({file}), "solutions; select one by solution=: "));
  EXPECT_TRUE(contains(refusal({file + ":a,solution=fd"}), "contains no solution 'fd'; use "));
  EXPECT_TRUE(contains(refusal({file + ":a,solution=fd-kf,case=case9"}), "no case 'case9'"));
}

TEST_F(JointDensityFiles, MayBeExternalNetCdf) {
  const auto write = [&](const std::string& name, bool swapped, const char* of_y) {
    constexpr int kN = 60;
    std::vector<double> y, v, p;
    for (int i = 0; i <= kN; ++i) y.push_back(axes_.y_edges.back() * i / kN);
    for (int j = -kN; j <= kN; ++j) v.push_back(axes_.v_edges.back() * j / kN);
    for (const double a : swapped ? v : y) {
      for (const double b : swapped ? y : v) {
        p.push_back(swapped ? value("fd-kf", b, a) : value("fd-kf", a, b));
      }
    }
    results::NetCdfWriter file;
    const int y_axis = file.define_dimension(of_y, y.size()),
              v_axis = file.define_dimension("v", v.size());
    file.write_variable(of_y, {y_axis}, "displacement", y);
    file.write_variable("v", {v_axis}, "velocity", v);
    file.write_variable(
        "density", swapped ? std::vector{v_axis, y_axis} : std::vector{y_axis, v_axis}, "p", p);
    std::ofstream(path(name), std::ios::binary) << file.close_and_take_bytes();
    return path(name);
  };
  const auto one = case_with({write("a.nc", false, "y"), write("b.nc", true, "y")});
  for (const char* id : {"a", "b"}) {
    EXPECT_LT(*one.l1_distance(id, "fd-kf", StateVariable::y), 1e-3);
    EXPECT_LT(*one.l1_distance(id, "fd-kf", StateVariable::ydot), 1e-3);
  }
  EXPECT_LT(*one.l1_distance("a", "b", StateVariable::y), 1e-12);
  EXPECT_TRUE(contains(refusal({write("c.nc", false, "q")}), "name them y and v"));
  EXPECT_TRUE(contains(refusal({path("a.nc") + ":d,solution=fd-kf"}), "omit the key solution"));
}

TEST_F(JointDensityFiles, MayBeClosedForms) {
  const auto write = [&](const std::string& name, const std::string& more) {
    std::ofstream(path(name)) << R"({"coordinates": "y,v", )" << more << R"("coefficients": [
        {"x1": 2, "x2": 0, "a": -1.17}, {"x1": 4, "x2": 0, "a": -0.06},
        {"x1": 0, "x2": 2, "a": -1.2}, {"x1": 0, "x2": 4, "a": 0.025}]})";
    return path(name);
  };
  // The form of fd-kf, with its support limited before the term v^4 increases again.
  const std::string support =
      fmt::format(R"("support": {{"y_max": {}, "v_max": {}}}, )", axes_.y_edges.back(), 4.5);
  const auto one = case_with({write("mine.json", support) + ",equation=kf"});
  const auto& mine = one.solutions.front();
  EXPECT_EQ(mine.status, Status::ok) << mine.reason;
  EXPECT_EQ(mine.identity.order, 4);
  EXPECT_LT(*one.l1_distance("mine", "fd-kf", StateVariable::y), 1e-4);
  EXPECT_LT(*one.l1_distance("mine", "fd-kf", StateVariable::ydot), 1e-3);
  // A given normalisation constant is used without normalisation.
  const auto wrong = case_with({write("wrong.json", support + "\"C\": 0.1, ")});
  EXPECT_EQ(wrong.solutions.front().status, Status::inadmissible);
  EXPECT_TRUE(contains(wrong.solutions.front().reason, "the integral is 0."));
  EXPECT_TRUE(
      contains(refusal({write("bad.json", "\"C\": 0, ")}), "\"C\" is 0 (must be positive)"));
}

TEST_F(JointDensityFiles, MayBeTheClosedFormOfASummary) {
  const epc::ClosureOptions options{.order = 6};
  auto solved = epc::solve_closure(tests::paper_case(2), options).solution;
  solved.identity = builtin_registry().find_method_by_id("epc-gaussian-n6")->identity;
  auto problem = tests::paper_case(2);
  problem.name = "case2";
  const results::Run run{
      results::current_program("fpkcheck run"),
      {results::make_case_result(problem, compare::comparison_bins(problem), {solved})}};
  std::ofstream(path("summary.json")) << results::run_summary_text(run);

  const auto axes = compare::comparison_bins(problem);
  const auto method =
      external_density_methods_from_files(
          std::vector{path("summary.json") + ",solution=epc-gaussian-n6"}, builtin_registry())
          .front();
  const auto again = solve_with_method(method, problem, {axes, {}});
  EXPECT_EQ(again.id(), "given-epc-gaussian-n6");
  EXPECT_EQ(transform::equation_and_impact_text(again.identity), "km4/delta");
  EXPECT_EQ(again.identity.order, 6);
  EXPECT_EQ(again.status, Status::ok) << again.reason;
  EXPECT_NEAR(again.moments.v2 / solved.moments.v2, 1, 1e-7);
  for (const auto variable : transform::kVariables) {
    const auto& edges = compare::comparison_bin_edges(axes, variable);
    EXPECT_LT(l1_distance(marginal(again, variable, edges), marginal(solved, variable, edges)),
              1e-6);
  }
  EXPECT_TRUE(contains(refusal({path("summary.json") + ":a,solution=mcs"}), "no solution 'mcs'"));
}

TEST_F(JointDensityFiles, AreRefusedIfInvalid) {
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  };
  using namespace std::string_literals;
  EXPECT_TRUE(contains(refusal({write("a.csv", "y,v\0\1"s)}), "a.csv is binary (must be columns"));
  EXPECT_TRUE(contains(refusal({write("a.nc", "CDF\1\0\0"s)}), "convert it to netCDF-4 by nccopy"));
  EXPECT_TRUE(contains(refusal({write("b.nc", "\x89HDF\r\n\x1a\n..."s)}), "b.nc: "));
  EXPECT_TRUE(contains(refusal({write("a.json", "{")}), "is not JSON"));
  EXPECT_TRUE(contains(refusal({write("b.json", "{}")}), "b.json: no \"coordinates\""));
  const auto joint = points_of("fd-kf", "joint.csv", 8);
  std::ofstream(path("y.csv")) << "y,p\n0,1\n1,0.5\n2,0.1\n3,0\n";
  EXPECT_TRUE(
      contains(refusal({joint + ":a", path("y.csv") + ":a"}), "one of them a joint density"));
  EXPECT_TRUE(
      contains(refusal({path("y.csv") + ":a", joint + ":a"}), "one of them a joint density"));
  EXPECT_TRUE(contains(refusal({joint + ":a,case=case1"}), "omit the key case"));
  std::string zeros = "y,v,p\n";
  for (int k = 0; k < 16; ++k) zeros += fmt::format("{},{},0\n", k / 4, k % 4);
  EXPECT_TRUE(contains(refusal({write("zero.csv", zeros)}), "'zero': the integral is 0"));
}

}  // namespace
}  // namespace fpkcheck::methods
