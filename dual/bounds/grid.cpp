#include "dual/bounds/grid.hpp"

#include <cmath>

namespace fpkcheck::dual {

SplineBasis displacement_basis(const Grid& grid, const Weight& weight) {
  // (k - c^2/4) y^2/2 + mu y^4/4 = edge h0
  const double a = weight.cubic / 4, b = (weight.stiffness - weight.damping * weight.damping / 4) / 2;
  const double energy = grid.edge * weight.scale;
  const double y = std::sqrt(2 * energy / (b + std::sqrt(b * b + 4 * a * energy)));
  return SplineBasis(graded_breaks(y, grid.y_cells, grid.finest * y, grid.even * y));
}

ImpactBasis velocity_basis(const Grid& grid, const Weight& weight, double restitution) {
  // v^2/2 = edge h0 for v = -u, or a little beyond with losses, as v = r u is the other edge
  const double u = std::sqrt(2 * grid.edge * weight.scale / restitution);
  return ImpactBasis(SplineBasis(graded_breaks(u, grid.speed_cells, grid.finest * u, grid.even * u)),
                     restitution);
}

Grid grid_of_level(int level) {
  const double factor = std::pow(1.4, level);
  return {static_cast<int>(std::lround(10 * factor)), static_cast<int>(std::lround(10 * factor)), 1e-3,
          0.1, 8};
}

}  // namespace fpkcheck::dual
