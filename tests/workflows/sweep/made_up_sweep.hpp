#pragma once

#include <string>
#include <vector>

#include "methods/builtin_solvers.hpp"
#include "paper_cases.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

/// Plans and results with invented numbers.
namespace fpkcheck::tests {

inline sweep::SweepPlan plan_of(std::vector<sweep::SweepAxis> axes,
                                sweep::SweepPlanDesign design = sweep::SweepPlanDesign::product,
                                const std::string& methods = "epc-gaussian-n2,fd-kf") {
  sweep::SweepPlan plan{.base = make_problem(), .axes = std::move(axes), .design = design};
  plan.methods = methods::builtin_registry().methods_selected_by_list(methods, {});
  plan.points = sweep::make_sweep_plan_points(plan.axes, design, 0);
  return plan;
}

/// A plan with one closure and without its error estimate: milliseconds for each point.
inline sweep::SweepPlan quick_plan(std::vector<sweep::SweepAxis> axes) {
  sweep::SweepPlan plan = plan_of(std::move(axes));
  plan.methods =
      methods::builtin_registry().methods_selected_by_list("epc-gaussian-n2", {{"accuracy", {}}});
  return plan;
}

/// Two rates and three restitutions.
inline sweep::SweepPlan small_plan() {
  return plan_of({sweep::parse_sweep_axis("impulse.rate", "1,2", "test"),
                  sweep::parse_sweep_axis("system.restitution", "0.8:1:3", "test")});
}

/// Numbers that identify the point and the method.
inline sweep::SweepPointResult result_of(const sweep::SweepPlan& plan, std::size_t point) {
  sweep::SweepPointResult result{.point = point,
                                 .seconds = 2 + 2 * static_cast<double>(point),
                                 .reference = plan.methods.back().id()};
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const double number = static_cast<double>(point) + 0.1 * static_cast<double>(m);
    result.methods.push_back({.status = transform::Status::ok,
                              .seconds = 1 + number,
                              .moments = transform::Moments{.y2 = number, .v2 = 2 * number}});
  }
  result.methods.front().l1 = sweep::MarginalL1Values{0.01 * static_cast<double>(point + 1), 0.02};
  result.methods.front().budget = {{"closure + impact", {0.3, 0.4}}};
  result.methods.back().slopes = {
      {plan.axes.front().key, 0.5, 0.25 * static_cast<double>(point), 0.01, 0.02}};
  return result;
}

inline sweep::SweepResults results_of(const sweep::SweepPlan& plan) {
  std::vector<sweep::SweepPointResult> points;
  for (std::size_t p = 0; p < plan.points.size(); ++p) points.push_back(result_of(plan, p));
  return sweep::make_sweep_results(plan, points);
}

}  // namespace fpkcheck::tests
