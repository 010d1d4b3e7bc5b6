#include "transform/change_of_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fpkcheck::transform {
namespace {

template <class Coordinate>
std::vector<double> carried(std::vector<double> edges, bool mirrored, const Coordinate& at) {
  for (double& edge : edges) edge = at(edge) + 0.0;  // turns -0 into 0
  if (mirrored) std::ranges::reverse(edges);
  return edges;
}

using Edges = std::vector<double>;

Edges known_edges_of(const problem::Frame& frame, const Edges& x_edges, const Edges& known) {
  return x_edges == x_edges_of(frame, known) ? known : y_edges_of(frame, x_edges);
}

GridDensity carried(const problem::Frame& frame, GridDensity grid, const Edges& known) {
  grid.y_edges = known_edges_of(frame, grid.y_edges, known);
  grid.v_edges = v_edges_of(frame, grid.v_edges);
  if (frame.mirrored) std::ranges::reverse(grid.averages);  // mirrors both axes at once
  return grid;
}

SmoothDensity carried(const problem::Frame& frame, SmoothDensity smooth, const Edges&) {
  const double from = frame.y(smooth.y_min), to = frame.y(smooth.y_max);
  return {.value = [frame, value = std::move(smooth.value)](
                       double y, double v) { return value(frame.x(y), frame.v(v)); },
          .y_max = std::max(from, to),
          .v_max = smooth.v_max,
          .y_min = std::min(from, to)};
}

Marginal carried(const problem::Frame& frame, Variable variable, Marginal marginal,
                 const Edges& known) {
  marginal.edges = variable == Variable::y ? known_edges_of(frame, marginal.edges, known)
                                           : v_edges_of(frame, marginal.edges);
  if (frame.mirrored) {
    for (auto* values : {&marginal.density, &marginal.lower, &marginal.upper}) {
      std::ranges::reverse(*values);
    }
  }
  return marginal;
}

}  // namespace

std::vector<double> y_edges_of(const problem::Frame& frame, const std::vector<double>& x_edges) {
  return carried(x_edges, frame.mirrored, [&](double x) { return frame.y(x); });
}

std::vector<double> x_edges_of(const problem::Frame& frame, const std::vector<double>& y_edges) {
  return carried(y_edges, frame.mirrored, [&](double y) { return frame.x(y); });
}

std::vector<double> v_edges_of(const problem::Frame& frame, const std::vector<double>& edges) {
  return carried(edges, frame.mirrored, [&](double v) { return frame.v(v); });
}

Density in_physical_coordinates(const problem::Frame& frame, Density density,
                                const Edges& y_edges) {
  if (frame.is_identity()) return density;
  return std::visit([&](auto& form) { return Density(carried(frame, std::move(form), y_edges)); },
                    density);
}

Density in_coordinates_of(const problem::Frame& frame, Density density) {
  return in_physical_coordinates(frame.inverse(), std::move(density));
}

Solution in_physical_coordinates(const problem::Frame& frame, Solution solution,
                                 const Edges& y_edges) {
  if (frame.is_identity()) return solution;
  if (solution.density) {
    solution.density = in_physical_coordinates(frame, std::move(*solution.density), y_edges);
  }
  if (solution.extrapolation) {
    solution.extrapolation->coarser =
        in_physical_coordinates(frame, std::move(solution.extrapolation->coarser), y_edges);
  }
  for (auto& [variable, marginal] : solution.estimated_marginals) {
    marginal = carried(frame, variable, std::move(marginal), y_edges);
  }
  for (RestAtom& atom : solution.atoms) atom.y = frame.y(atom.y);
  return solution;
}

}  // namespace fpkcheck::transform
