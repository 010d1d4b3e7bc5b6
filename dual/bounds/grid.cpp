#include "dual/bounds/grid.hpp"

#include <cmath>

namespace fpkcheck::dual {

SplineBasis displacement_basis(const Grid& grid, const Weight& weight) {
  // (k - c^2/4) y^2/2 + mu y^4/4 = edge h0
  const double a = weight.cubic / 4,
               b = (weight.stiffness - weight.damping * weight.damping / 4) / 2;
  const double energy = grid.edge * weight.scale;
  const double y = std::sqrt(2 * energy / (b + std::sqrt(b * b + 4 * a * energy)));
  return SplineBasis(graded_breaks(y, grid.y_cells, grid.finest * y, grid.even * y));
}

ImpactBasis velocity_basis(const Grid& grid, const Weight& weight, double restitution) {
  // v^2/2 = edge h0 for v = -u. With losses further: v = r u is the other edge, and G there must
  // not be small either.
  const double u = std::sqrt(2 * grid.edge * weight.scale) / std::pow(restitution, 0.85);
  return ImpactBasis(
      SplineBasis(graded_breaks(u, grid.speed_cells, grid.finest * u, grid.even * u)), restitution);
}

Grid grid_of_level(int level, Smoothness integrand) {
  // V has a conical point at the origin: the error falls with the cells there as long as they are
  // the worst. Much finer ones than these cost digits of the normal equations.
  static constexpr Grid kSmooth[kLevels] = {{16, 16, 3e-3, 0.3, 7},
                                            {22, 22, 1e-3, 0.2, 7.5},
                                            {28, 28, 3e-4, 0.2, 8},
                                            {40, 40, 6e-5, 0.2, 8},
                                            {56, 56, 1.5e-5, 0.15, 8.5}};
  // The motion carries the knots of a bin all over the phase plane.
  static constexpr Grid kPiecewise[kLevels] = {{20, 28, 3e-2, 0.1, 6},
                                               {28, 40, 3e-2, 0.1, 6},
                                               {36, 50, 3e-2, 0.1, 6},
                                               {50, 70, 2e-2, 0.1, 6},
                                               {64, 90, 1e-2, 0.1, 6}};
  return integrand == Smoothness::smooth ? kSmooth[level] : kPiecewise[level];
}

}  // namespace fpkcheck::dual
