#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "compare/case_report.hpp"
#include "paper_cases.hpp"
#include "transform/panel_marginals.hpp"
#include "trapezoid.hpp"

/// Solutions that no solver made: the shapes and the sizes of the differences are those of a real
/// run, the values are known in advance.
namespace fpkcheck::tests {

/// p(y, v) ~ exp(-a y^2/2 - b y^4) exp(-d v^2/2 - e v^4 + f v^6) on a box.
struct Shape {
  double a, b, d, e, f = 0;
};

inline transform::SmoothDensity smooth(const Shape& s, double y_max, double v_max) {
  const auto of_y = [s](double y) { return std::exp(-s.a * y * y / 2 - s.b * std::pow(y, 4)); };
  const auto of_v = [s](double v) {
    return std::exp(-s.d * v * v / 2 - s.e * std::pow(v, 4) + s.f * std::pow(v, 6));
  };
  const double norm = trapezoid(of_y, 0, y_max, 2000) * trapezoid(of_v, -v_max, v_max, 2000);
  return {[=](double y, double v) { return of_y(y) * of_v(v) / norm; }, y_max, v_max};
}

inline compare::Entry entry(const std::string& id, const std::string& method,
                            const std::string& equation, problem::Impact impact,
                            const transform::SmoothDensity& density) {
  transform::Solution s;
  s.id = id;
  s.method = method;
  s.equation = equation;
  s.impact = impact;
  s.status = transform::Status::ok;
  s.seconds = 0.42;
  s.density = density;
  s.moments = transform::panel_marginals(density, density.y_max, density.v_max).moments;
  s.mass = 1;
  s.energy_residual = -1.5e-3;
  return {s, nlohmann::ordered_json::object(), nlohmann::ordered_json::object()};
}

/// A histogram of `samples` independent samples of the density on the axes, with intervals.
inline compare::Entry simulation(const compare::ComparisonAxes& axes,
                                 const transform::SmoothDensity& density, double samples) {
  auto result = entry("mcs", "mcs", "kf", problem::Impact::exact, density);
  auto& s = result.solution;
  s.density.reset();
  std::mt19937_64 random(1);
  for (const auto variable : {transform::Variable::y, transform::Variable::ydot}) {
    auto m = transform::marginal(density, variable, compare::edges(axes, variable));
    for (std::size_t k = 0; k < m.size(); ++k) {
      const double weight = samples * m.width(k);
      std::poisson_distribution<long> count(weight * m.density[k]);
      m.density[k] = static_cast<double>(count(random)) / weight;
      const double half = 1.96 * std::sqrt(m.density[k] / weight);
      m.lower.push_back(m.density[k] - half);
      m.upper.push_back(m.density[k] + half);
    }
    s.estimated_marginals.emplace_back(variable, m);
  }
  result.details = {{"samples", samples},
                    {"sampling_l1", {{"y", 0.0011}, {"ydot", 0.0015}}},
                    {"standard_errors", {{"y2", 1e-4}, {"v2", 1e-4}}}};
  return result;
}

inline compare::Entry without_density(const std::string& id, transform::Status status) {
  transform::Solution s;
  s.id = id;
  s.method = "epc";
  s.equation = "km4";
  s.impact = problem::Impact::delta;
  s.status = status;
  s.reason =
      "the residual stopped falling at 0.013 after 60 Newton steps; the best of five starts is "
      "reported";
  s.seconds = 12.3;
  return {s, nlohmann::ordered_json::object(), {{"order", 8}, {"formulation", "gaussian"}}};
}

/// The eight solutions of one case, in the order of trust: four closures, three equations by finite
/// differences, the simulation.
inline compare::CaseReport full_report(const std::string& name = "case1") {
  auto problem = paper_case(1);
  problem.name = name;
  const auto axes = compare::comparison_axes(problem);
  const double y_max = axes.y_edges.back(), v_max = axes.v_edges.back();
  const auto shape = [&](const Shape& s) { return smooth(s, y_max, v_max); };
  using problem::Impact;
  const auto closure = [&](const std::string& id, int order, const Shape& s) {
    auto made = entry(id, "epc", "km4", Impact::delta, shape(s));
    made.details = {{"order", order}, {"formulation", "gaussian"}};
    return made;
  };
  std::vector<compare::Entry> entries;
  entries.push_back(closure("epc-gaussian-n2", 2, {2.54, 0, 2.27, 0}));
  entries.push_back(closure("epc-gaussian-n4", 4, {2.5, -0.02, 2.4, -0.035}));
  entries.back().solution.status = transform::Status::inadmissible;
  entries.back().solution.reason = "the leading form is positive along y: Q rises from y = 5.1 on";
  entries.push_back(closure("epc-gaussian-n6", 6, {2.345, 0.061, 2.395, -0.0249, -0.0002}));
  entries.push_back(without_density("epc-gaussian-n8", transform::Status::not_converged));
  entries.push_back(entry("fd-white", "fd", "white", Impact::map, shape({2.33, 0.055, 2.27, 0})));
  entries.push_back(entry("fd-km4", "fd", "km4", Impact::map, shape({2.3401, 0.06, 2.4, -0.0251})));
  entries.push_back(entry("fd-kf", "fd", "kf", Impact::map, shape({2.34, 0.06, 2.4, -0.025})));
  entries.push_back(simulation(axes, shape({2.34, 0.06, 2.4, -0.025}), 1e7));
  return compare::report_on_case(problem, axes, std::move(entries));
}

}  // namespace fpkcheck::tests
