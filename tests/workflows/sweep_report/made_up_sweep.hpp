#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "made_up_solutions.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

/// Sweeps with invented results and distinguishable numbers.
namespace fpkcheck::tests {

using KeyAndValues = std::pair<std::string, std::string>;

/// Indices of the methods.
enum MadeUpMethod { made_up_gaussian, made_up_moment, made_up_white, made_up_reference };

inline sweep::SweepPlan made_up_plan(
    const std::vector<KeyAndValues>& axes,
    sweep::SweepPlanDesign design = sweep::SweepPlanDesign::product, std::size_t sobol_points = 0) {
  using problem::DensityEquation;
  using problem::ImpactCondition;
  sweep::SweepPlan plan{.base = paper_case(1), .axes = {}, .design = design};
  plan.sobol_points = sobol_points;
  plan.base.name = "case1";
  for (const auto& [key, values] : axes)
    plan.axes.push_back(sweep::parse_sweep_axis(key, values, "test"));
  for (const auto& who : {closure_identity("gaussian", 4), closure_identity("moment", 4),
                          identity("fd-white", "fd", DensityEquation::white, ImpactCondition::map),
                          identity("fd-kf", "fd", DensityEquation::kf, ImpactCondition::map)}) {
    plan.methods.emplace_back();
    plan.methods.back().identity = who;
  }
  plan.points = sweep::make_sweep_plan_points(plan.axes, design, sobol_points);
  return plan;
}

/// Distances of moment fall from 0.2 to 0.002 over the points, those of fd-white are 0.03, those of
/// gaussian 0.4. gaussian is inadmissible except at the second point. fd-kf is the reference.
inline sweep::SweepResults made_up_sweep(sweep::SweepPlan plan) {
  using transform::Status;
  std::vector<sweep::SweepPointResult> points;
  for (std::size_t k = 0; k < plan.points.size(); ++k) {
    const double part = plan.points.size() == 1 ? 0
                                                : static_cast<double>(k) /
                                                      (static_cast<double>(plan.points.size()) - 1);
    const double l1 = 0.2 * std::pow(0.01, part);
    const transform::Moments moments{.y2 = 0.4 + 0.1 * part, .v2 = 0.5 + 0.1 * part};
    sweep::SweepPointResult point{.point = k, .reference = "fd-kf"};
    point.methods = {{.status = k == 1 ? Status::ok : Status::inadmissible,
                      .reason = k == 1 ? "" : "it is " + std::to_string(k) + ".5 off",
                      .seconds = 0.01,
                      .moments = transform::Moments{.y2 = 9, .v2 = 8},
                      .l1 = sweep::MarginalL1Values{0.4, 0.3},
                      .error = sweep::MarginalL1Values{0.45, 0.35}},
                     {.status = Status::ok,
                      .seconds = 0.02,
                      .moments = moments,
                      .l1 = sweep::MarginalL1Values{l1 / 2, l1}},
                     {.status = Status::ok,
                      .seconds = 1,
                      .moments = moments,
                      .l1 = sweep::MarginalL1Values{0.03, 0.02}},
                     {.status = Status::ok,
                      .seconds = 2,
                      .moments = moments,
                      .error = sweep::MarginalL1Values{2e-5, 3e-5}}};
    if (k == 1) point.methods[made_up_gaussian].moments = moments;
    points.push_back(std::move(point));
  }
  return sweep::make_sweep_results(std::move(plan), std::move(points));
}

inline sweep::SweepResults made_up_sweep(const std::vector<KeyAndValues>& axes) {
  return made_up_sweep(made_up_plan(axes));
}

/// The result of a solver that failed.
inline sweep::SweepMethodResult made_up_failure(const std::string& reason = "it broke down") {
  return {.status = transform::Status::failed, .reason = reason, .seconds = 0.1};
}

inline const KeyAndValues kFiveRestitutions{"system.restitution", "0.6:1:5"};
inline const KeyAndValues kThreeRates{"impulse.rate", "log:0.1:10:3"};
inline const KeyAndValues kTwoLaws{"impulse.law", "gaussian,laplace"};

}  // namespace fpkcheck::tests
