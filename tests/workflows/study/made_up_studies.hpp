#pragma once

#include <sstream>
#include <string>
#include <utility>

#include "made_up_solutions.hpp"
#include "workflows/study/closure_order_study.hpp"
#include "workflows/study/grid_convergence_study.hpp"
#include "workflows/study/kramers_moyal_regularisation_study.hpp"

/// Studies with invented solutions and distinguishable numbers.
namespace fpkcheck::tests {

inline transform::Solution ok(const transform::SolutionIdentity& who, double seconds) {
  return {
      .identity = who, .status = transform::Status::ok, .seconds = seconds, .had_density = true};
}

inline transform::Solution not_ok(const transform::SolutionIdentity& who,
                                  transform::Status status) {
  return {.identity = who, .status = status, .reason = "it is made up", .seconds = 0.002};
}

/// Two schemes on three grids each; the density of the coarsest grid is not ok.
inline study::GridStudy made_up_grid_study() {
  const auto fd =
      identity("fd-kf", "fd", problem::DensityEquation::kf, problem::ImpactCondition::map);
  study::GridStudy study{paper_case(1), fd, {}, {}, {}};
  study.problem.name = "case1";
  for (const int order : {3, 5}) {
    for (int level = 1; level <= 3; ++level) {
      study::GridStudyRow row{.order = order,
                              .level = level,
                              .refinement = 0.5 * level,
                              .nx = 10 * level,
                              .nv = 20 * level,
                              .solution = ok(fd, 0.1 * level * order)};
      row.density = transform::GridLevelSolution{{}, {}, {.y2 = 0.4, .v2 = 0.5}};
      row.l1 = study::MarginalL1Distances{0.1 / level / order / order, 0.2 / level / order / order};
      if (level == 1) row.solution = not_ok(fd, transform::Status::inadmissible);
      if (level == 3)
        row.observed = transform::ObservedConvergenceOrders{order - 0.25, 7, HUGE_VAL};
      study.rows.push_back(row);
    }
    study.limits.push_back(
        {.order = order,
         .density = transform::GridLevelSolution{{}, {}, {.y2 = 0.39451776, .v2 = 0.4415}},
         .error = {.y2 = 1e-6, .v2 = 2e-6},
         .l1 = study::MarginalL1Distances{order == 5 ? 0 : 1.2e-4, 1.4e-4}});
  }
  study.limit_accuracy = study.limits.front().l1;
  study.others.push_back({ok(closure_identity("gaussian", 2), 0.0067), {{4.4e-3, 3e-2}}});
  study.others.push_back(
      {not_ok(closure_identity("gaussian", 4), transform::Status::inadmissible)});
  study.others.push_back({ok(closure_identity("moment", 4), 0.03), {{5e-4, 6e-4}}});
  study.others.push_back(
      {ok(identity("mcs", "mcs", problem::DensityEquation::kf, problem::ImpactCondition::exact), 2),
       {{1e-3, 2e-3}}});
  study.others.back().solution.sampling = {.y = 0.0011, .ydot = 0.0015};
  return study;
}

/// gaussian at n = 2, 4, 8 and moment at n = 4, 6; gaussian-n8 followed a branch.
inline study::ClosureOrderStudy made_up_order_study() {
  const auto fd =
      identity("fd-kf", "fd", problem::DensityEquation::kf, problem::ImpactCondition::map);
  study::ClosureOrderStudy study{paper_case(1), ok(fd, 0.6), {}};
  study.problem.name = "case1";
  const auto add = [&](const std::string& formulation, int order, double l1) {
    study::ClosureOrderStudyRow row{formulation,
                                    order,
                                    formulation == "moment",
                                    ok(closure_identity(formulation, order), 0.001 * order),
                                    study::MarginalL1Distances{l1, 2 * l1},
                                    0.02 * order};
    row.solution.metrics =
        transform::SolverMetricsBuilder()
            .add_result_metric("order", transform::value_from_count(order))
            .add_result_metric("formulation", formulation.substr(0, 6))
            .add_diagnostic_metric("iterations", transform::value_from_count(7 * order))
            .add_diagnostic_metric("residual", 1e-15)
            .add_result_metric("support.edge_density", 1e-14)
            .add_result_metric("leading_form", std::string("negative"))
            .take_metrics();
    study.rows.push_back(row);
  };
  add("gaussian", 2, 0.004);
  add("gaussian", 4, 0.026);
  study.rows.back().solution.status = transform::Status::inadmissible;
  study.rows.back().solution.reason = "Q_n rises";
  add("gaussian", 8, 0);
  auto& lost = study.rows.back();
  lost.solution = not_ok(lost.solution.identity, transform::Status::not_converged);
  lost.l1.reset();
  lost.tail_y.reset();
  lost.solution.metrics = transform::SolverMetricsBuilder()
                              .add_result_metric("branch.end", std::string("white_noise"))
                              .add_result_metric("branch.furthest", 0.655)
                              .add_diagnostic_metric("branch.points[0].fraction", 0.0)
                              .add_diagnostic_metric("branch.points[0].norm", 1.0)
                              .add_diagnostic_metric("branch.points[0].fold", false)
                              .add_diagnostic_metric("branch.points[1].fraction", 0.655)
                              .add_diagnostic_metric("branch.points[1].norm", 2.5)
                              .add_diagnostic_metric("branch.points[1].fold", true)
                              .take_metrics();
  add("moment", 4, 0.008);
  add("moment", 6, 0.002);
  study.rows.back().solution.metrics.push_back(
      {"tail.polynomial_leading_form", std::string("indefinite")});
  return study;
}

/// Rows without growth, rows that grow, and one row without results.
inline study::KramersMoyalRegularisationStudy made_up_regularisation_study() {
  using Row = fd_fpk::KramersMoyalRegularisationResult;
  const auto settled = [&](const char* scheme, double step, double length) {
    return Row{.scheme = scheme,
               .step = step,
               .length = length,
               .nx = 16,
               .nv = 60,
               .symbol = fd_fpk::FastestGrowingWave{-1e-6, 0.01},
               .rightmost = -1e-15,
               .next = std::complex(-0.119, 2.1),
               .l1_y = 0.0003,
               .l1_ydot = 0.0004,
               .min_density = -1e-7};
  };
  const auto growing = [&](const char* scheme, double step, double length, double rate) {
    return Row{.scheme = scheme,
               .step = step,
               .length = length,
               .nx = 16,
               .nv = 60,
               .symbol = fd_fpk::FastestGrowingWave{1.1 * rate, 3 / step},
               .rightmost = rate,
               .l1_y = 4.1,
               .l1_ydot = 2.3,
               .min_density = -0.47};
  };
  const Row unsolved{
      .scheme = "pade", .step = 0.2, .length = 0, .nx = 16, .nv = 60, .remark = "there is none"};
  return study::add_density_growth_rates(
      make_problem(),
      {.default_length = 0.4,
       .shortest_length = 0.3,
       .rows = {settled("literal", 0.4, 0.4), growing("literal", 0.2, 0.2, 20),
                growing("literal", 0.1, 0.1, 320), growing("0.9 l*", 0.1, 0.27, 1.5),
                settled("1.1 l*", 0.1, 0.33), settled("regularised", 0.4, 0.4),
                settled("regularised", 0.1, 0.4), unsolved}});
}

/// The words of a text, separated by one blank.
inline std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += word + ' ';
  return line;
}

inline std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

}  // namespace fpkcheck::tests
