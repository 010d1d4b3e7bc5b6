#include "compare/joint_density.hpp"

#include <variant>

namespace fpkcheck::compare {
namespace {

std::vector<double> every_second(const std::vector<double>& edges) {
  std::vector<double> result;
  for (std::size_t k = 0; k < edges.size(); k += 2) result.push_back(edges[k]);
  if (edges.size() % 2 == 0) result.push_back(edges.back());
  return result;
}

}  // namespace

std::vector<JointDensity> joint_densities(std::span<const CaseReport> cases) {
  std::vector<JointDensity> joints;
  for (const auto& report : cases) {
    const auto y_edges = every_second(report.axes.y_edges);
    for (const auto& entry : report.entries) {
      if (!entry.solution.density) continue;
      auto density = std::visit(
          [&](const auto& form) { return transform::on_cells(form, y_edges, report.axes.v_edges); },
          *entry.solution.density);
      for (double& average : density.averages) average = static_cast<float>(average);
      joints.push_back({report.problem.name, entry.solution.id, std::move(density)});
    }
  }
  return joints;
}

}  // namespace fpkcheck::compare
