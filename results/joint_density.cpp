#include "results/joint_density.hpp"

#include <variant>

namespace fpkcheck::results {
namespace {

std::vector<double> every_second_edge(const std::vector<double>& edges) {
  std::vector<double> result;
  for (std::size_t k = 0; k < edges.size(); k += 2) result.push_back(edges[k]);
  if (edges.size() % 2 == 0) result.push_back(edges.back());
  return result;
}

}  // namespace

std::vector<JointDensity> joint_densities(const compare::ComparisonAxes& axes,
                                          std::span<const transform::Solution> solutions) {
  std::vector<JointDensity> joints;
  const auto even = compare::uniform_axes(axes);
  const auto y_edges = every_second_edge(even.y_edges);
  for (const auto& solution : solutions) {
    if (!solution.density) continue;
    auto density = std::visit(
        [&](const auto& form) {
          return transform::average_over_cells(form, y_edges, even.v_edges);
        },
        *solution.density);
    for (double& average : density.averages) average = static_cast<float>(average);
    joints.push_back({solution.id(), std::move(density)});
  }
  return joints;
}

}  // namespace fpkcheck::results
