#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "paper_cases.hpp"
#include "results/run.hpp"
#include "transform/marginal_density.hpp"
#include "trapezoid.hpp"

/// Synthetic solutions for tests. Shapes and sizes of the differences are similar to those of a
/// real run; the exact values are known.
namespace fpkcheck::tests {

/// Coefficients of p(y, v) ~ exp(-a y^2/2 - b y^4) exp(-d v^2/2 - e v^4 + f v^6) on a box.
struct Shape {
  double a, b, d, e, f = 0;
};

inline transform::SmoothDensity smooth_density(const Shape& s, double y_max, double v_max) {
  const auto of_y = [s](double y) { return std::exp(-s.a * y * y / 2 - s.b * std::pow(y, 4)); };
  const auto of_v = [s](double v) {
    return std::exp(-s.d * v * v / 2 - s.e * std::pow(v, 4) + s.f * std::pow(v, 6));
  };
  const double norm = trapezoid(of_y, 0, y_max, 2000) * trapezoid(of_v, -v_max, v_max, 2000);
  return {[=](double y, double v) { return of_y(y) * of_v(v) / norm; }, y_max, v_max};
}

/// The identity of a synthetic solution, with a plot style as of the built-in methods.
inline transform::SolutionIdentity identity(const std::string& id, const std::string& method,
                                            problem::DensityEquation equation,
                                            problem::ImpactCondition impact) {
  using transform::SolutionRole;
  transform::SolutionIdentity solution_identity{
      .id = id, .method = method, .equation = equation, .impact = impact};
  solution_identity.role = method == "epc"  ? SolutionRole::closure
                           : method == "fd" ? SolutionRole::equation
                                            : SolutionRole::simulation;
  solution_identity.family = method;
  solution_identity.meaning = "What " + method + " makes.";
  solution_identity.plot_style = {.colour = method == "fd" ? "#56B4E9" : "#000000",
                                  .dash = "solid",
                                  .width = method == "fd" ? 5.0 : 1.0,
                                  .as_points = method == "mcs",
                                  .layer = static_cast<int>(solution_identity.role),
                                  .symbol = "circle"};
  return solution_identity;
}

inline transform::SolutionIdentity closure_identity(const std::string& formulation, int order) {
  auto solution_identity = identity("epc-" + formulation + "-n" + std::to_string(order), "epc",
                                    problem::DensityEquation::km4, problem::ImpactCondition::delta);
  solution_identity.formulation = formulation;
  solution_identity.order = order;
  solution_identity.family = "epc-" + formulation;
  solution_identity.plot_style.colour = formulation == "gaussian" ? "#D55E00" : "#CC79A7";
  solution_identity.plot_style.dash = "(10,4)";
  solution_identity.plot_style.width = 2;
  return solution_identity;
}

inline transform::Solution solution(const transform::SolutionIdentity& solution_identity,
                                    const transform::SmoothDensity& density) {
  transform::Solution s{.identity = solution_identity};
  s.status = transform::Status::ok;
  s.seconds = 0.42;
  s.density = density;
  s.moments =
      transform::marginals_at_quadrature_points(density, density.y_max, density.v_max).moments;
  s.mass = 1;
  s.energy_residual = -1.5e-3;
  return s;
}

/// A histogram of `samples` independent samples of the density on the axes, with 95 % intervals.
inline transform::Solution simulation(const compare::ComparisonBins& axes,
                                      const transform::SmoothDensity& density, double samples) {
  auto s = solution(
      identity("mcs", "mcs", problem::DensityEquation::kf, problem::ImpactCondition::exact),
      density);
  s.density.reset();
  std::mt19937_64 random(1);
  for (const auto variable : transform::kVariables) {
    auto m = transform::marginal(density, variable, compare::comparison_bin_edges(axes, variable));
    for (std::size_t k = 0; k < m.size(); ++k) {
      const double weight = samples * m.bin_width(k);
      std::poisson_distribution<long> count(weight * m.density[k]);
      m.density[k] = static_cast<double>(count(random)) / weight;
      const double half = 1.96 * std::sqrt(m.density[k] / weight);
      m.lower.push_back(m.density[k] - half);
      m.upper.push_back(m.density[k] + half);
    }
    s.estimated_marginals.emplace_back(variable, m);
  }
  s.sampling = {.y = 0.0011, .ydot = 0.0015};
  s.standard_errors = {.moments = {.y2 = 1e-4, .v2 = 1e-4}};
  s.metrics = transform::SolverMetricsBuilder()
                  .add_diagnostic_metric("samples", samples)
                  .add_diagnostic_metric("streams", std::int64_t{128})
                  .take_metrics();
  return s;
}

inline transform::Solution solution_without_density(
    const transform::SolutionIdentity& solution_identity, transform::Status status) {
  transform::Solution s{.identity = solution_identity};
  s.status = status;
  s.reason =
      "the residual stopped falling at 0.013 after 60 Newton steps; the best of five starts is "
      "reported";
  s.seconds = 12.3;
  return s;
}

/// Eight solutions of a case by increasing trust: four closures, three finite-volume solutions, the
/// simulation.
inline std::vector<transform::Solution> made_up_solutions(const compare::ComparisonBins& axes) {
  const double y_max = axes.y_edges.back(), v_max = axes.v_edges.back();
  const auto shape = [&](const Shape& s) { return smooth_density(s, y_max, v_max); };
  using problem::DensityEquation;
  using problem::ImpactCondition;
  const auto fd = [&](const std::string& id, DensityEquation equation, const Shape& s) {
    return solution(identity(id, "fd", equation, ImpactCondition::map), shape(s));
  };
  std::vector<transform::Solution> all;
  all.push_back(solution(closure_identity("gaussian", 2), shape({2.54, 0, 2.27, 0})));
  all.push_back(solution(closure_identity("gaussian", 4), shape({2.5, -0.02, 2.4, -0.035})));
  all.back().status = transform::Status::inadmissible;
  all.back().reason = "the leading form is positive along y: Q rises from y = 5.1 on";
  all.push_back(
      solution(closure_identity("gaussian", 6), shape({2.345, 0.061, 2.395, -0.0249, -0.0002})));
  all.push_back(
      solution_without_density(closure_identity("gaussian", 8), transform::Status::not_converged));
  all.push_back(fd("fd-white", DensityEquation::white, {2.33, 0.055, 2.27, 0}));
  all.push_back(fd("fd-km4", DensityEquation::km4, {2.3401, 0.06, 2.4, -0.0251}));
  all.push_back(fd("fd-kf", DensityEquation::kf, {2.34, 0.06, 2.4, -0.025}));
  all.push_back(simulation(axes, shape({2.34, 0.06, 2.4, -0.025}), 1e7));
  return all;
}

/// Case 1 of the paper with the synthetic solutions, under a given name.
inline results::CaseResult made_up_case(const std::string& name = "case1") {
  auto problem = paper_case(1);
  problem.name = name;
  const auto axes = compare::comparison_bins(problem);
  return results::make_case_result(problem, axes, made_up_solutions(axes));
}

/// Adds the estimates with control variates to a simulation: averages of a density over smooth
/// bins, every other average increased by a standard error, all independent.
inline void add_smooth_estimates(transform::Solution& simulation,
                                 const compare::ComparisonBins& axes,
                                 const transform::SmoothDensity& density, double error) {
  for (const auto variable : transform::kVariables) {
    const auto& edges = compare::comparison_bin_edges(axes, variable);
    const bool of_y = variable == transform::StateVariable::y;
    const double spacing = edges.back() / (of_y ? 46 : 23);
    transform::SmoothBinEstimate e{
        .bins =
            of_y ? transform::SmoothBins{.first = -spacing,
                                         .spacing = spacing,
                                         .count = 46,
                                         .from = 0}
                 : transform::SmoothBins{.first = -21 * spacing, .spacing = spacing, .count = 43},
        .averages = {},
        .covariance = {}};
    e.averages =
        transform::average_over_smooth_bins(transform::marginal(density, variable, edges), e.bins);
    const auto n = e.averages.size();
    e.covariance.assign(n * n, 0.0);
    for (std::size_t b = 0; b < n; ++b) {
      e.averages.density[b] += b % 2 == 0 ? error : 0;
      e.averages.lower.push_back(e.averages.density[b] - 1.96 * error);
      e.averages.upper.push_back(e.averages.density[b] + 1.96 * error);
      e.covariance[b * n + b] = error * error;
    }
    simulation.smooth_estimates.emplace_back(variable, std::move(e));
  }
  simulation.smooth_sampling = {.y = 3e-6, .ydot = 4e-6, .y_99 = 5e-6, .ydot_99 = 6e-6};
}

/// made_up_case() with estimates by control variates in the simulation.
inline results::CaseResult made_up_case_with_control_variates(double error = 1e-6) {
  const auto problem = made_up_case().problem;
  const auto axes = compare::comparison_bins(problem);
  auto solutions = made_up_solutions(axes);
  add_smooth_estimates(
      solutions.back(), axes,
      smooth_density({2.34, 0.06, 2.4, -0.025}, axes.y_edges.back(), axes.v_edges.back()), error);
  return results::make_case_result(problem, axes, std::move(solutions));
}

}  // namespace fpkcheck::tests
