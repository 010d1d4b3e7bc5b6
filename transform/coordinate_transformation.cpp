#include "transform/coordinate_transformation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fpkcheck::transform {

SmoothDensity zhuravlev_transform(ZhuravlevDensity density) {
  const double y_max = density.x1_max;
  const double v_max = density.x2_max;
  return {[p = std::move(density.value)](double y, double v) { return p(y, v) + p(-y, -v); }, y_max,
          v_max};
}

namespace {

template <class Coordinate>
std::vector<double> transform_edges(std::vector<double> edges, bool mirrored,
                                    const Coordinate& at) {
  for (double& edge : edges) edge = at(edge) + 0.0;  // adding 0 turns -0 into +0
  if (mirrored) std::ranges::reverse(edges);
  return edges;
}

using Edges = std::vector<double>;

Edges exact_y_edges(const problem::WallFrame& frame, const Edges& x_edges, const Edges& y_edges) {
  return x_edges == wall_coordinate_edges(frame, y_edges)
             ? y_edges
             : y_edges_from_wall_coordinates(frame, x_edges);
}

GridDensity to_physical_form(const problem::WallFrame& frame, GridDensity grid,
                             const Edges& y_edges) {
  grid.y_edges = exact_y_edges(frame, grid.y_edges, y_edges);
  grid.v_edges = transform_v_edges(frame, grid.v_edges);
  if (frame.mirrored)
    std::ranges::reverse(grid.averages);  // reversing the row-major averages mirrors both axes
  return grid;
}

SmoothDensity to_physical_form(const problem::WallFrame& frame, SmoothDensity smooth,
                               const Edges&) {
  const double from = frame.physical_y(smooth.y_min), to = frame.physical_y(smooth.y_max);
  return {.value =
              [frame, value = std::move(smooth.value)](double y, double v) {
                return value(frame.wall_coordinate(y), frame.physical_velocity(v));
              },
          .y_max = std::max(from, to),
          .v_max = smooth.v_max,
          .y_min = std::min(from, to)};
}

Marginal to_physical_form(const problem::WallFrame& frame, StateVariable variable,
                          Marginal marginal, const Edges& y_edges) {
  marginal.edges = variable == StateVariable::y ? exact_y_edges(frame, marginal.edges, y_edges)
                                                : transform_v_edges(frame, marginal.edges);
  if (frame.mirrored) {
    for (auto* values : {&marginal.density, &marginal.lower, &marginal.upper}) {
      std::ranges::reverse(*values);
    }
  }
  return marginal;
}

}  // namespace

std::vector<double> y_edges_from_wall_coordinates(const problem::WallFrame& frame,
                                                  const std::vector<double>& x_edges) {
  return transform_edges(x_edges, frame.mirrored, [&](double x) { return frame.physical_y(x); });
}

std::vector<double> wall_coordinate_edges(const problem::WallFrame& frame,
                                          const std::vector<double>& y_edges) {
  return transform_edges(y_edges, frame.mirrored,
                         [&](double y) { return frame.wall_coordinate(y); });
}

std::vector<double> transform_v_edges(const problem::WallFrame& frame,
                                      const std::vector<double>& edges) {
  return transform_edges(edges, frame.mirrored,
                         [&](double v) { return frame.physical_velocity(v); });
}

Density to_physical_coordinates(const problem::WallFrame& frame, Density density,
                                const Edges& y_edges) {
  if (frame.is_identity()) return density;
  return std::visit(
      [&](auto& form) { return Density(to_physical_form(frame, std::move(form), y_edges)); },
      density);
}

Density to_wall_coordinates(const problem::WallFrame& frame, Density density) {
  return to_physical_coordinates(frame.inverse_frame(), std::move(density));
}

Solution to_physical_coordinates(const problem::WallFrame& frame, Solution solution,
                                 const Edges& y_edges) {
  if (frame.is_identity()) return solution;
  if (solution.density) {
    solution.density = to_physical_coordinates(frame, std::move(*solution.density), y_edges);
  }
  if (solution.extrapolation) {
    solution.extrapolation->coarser =
        to_physical_coordinates(frame, std::move(solution.extrapolation->coarser), y_edges);
  }
  for (auto& [variable, marginal] : solution.estimated_marginals) {
    marginal = to_physical_form(frame, variable, std::move(marginal), y_edges);
  }
  for (RestAtom& atom : solution.atoms) atom.y = frame.physical_y(atom.y);
  return solution;
}

}  // namespace fpkcheck::transform
