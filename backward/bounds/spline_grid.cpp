#include "backward/bounds/spline_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace fpkcheck::backward {
namespace {

// Argument `finest` of numerics::graded_break_points as a fraction of the extent of y, for splines
// that do not begin at y = 0 or end at a wall
constexpr double kFinestFractionWithOtherWalls = 3e-2;

}  // namespace

numerics::SplineBasis make_displacement_spline_basis(const SplineGrid& grid,
                                                     const ResidualWeightFunctionOfEnergy& weight,
                                                     const problem::System& system) {
  // The splines of y end where (k - c^2/4) y^2/2 + mu y^4/4 = edge_energy h0, with energy scale h0.
  const double a = weight.cubic_stiffness / 4,
               b = (weight.stiffness - weight.damping * weight.damping / 4) / 2;
  const double energy = grid.edge_energy * weight.energy_scale;
  const double y = std::sqrt(2 * energy / (b + std::sqrt(b * b + 4 * a * energy)));
  const double begin = system.left_wall() ? std::max(-y, system.left_wall()->position) : -y;
  const double end = system.right_wall() ? std::min(y, system.right_wall()->position) : y;
  if (begin == 0 && end == y) {
    return numerics::SplineBasis(numerics::graded_break_points(
        y, grid.y_cell_count, grid.finest_fraction * y, grid.uniform_from_fraction * y));
  }
  // The certificate V is not smooth across the orbits that graze a wall (with velocity 0). The
  // widths of the spline cells vary little, since the grazing orbits cross the whole phase plane.
  const double width = end - begin;
  const int cells = static_cast<int>(std::ceil(grid.y_cell_count * std::max(0.5, width / y)));
  std::vector<double> breaks = numerics::graded_break_points(
      width, cells, kFinestFractionWithOtherWalls * width, grid.uniform_from_fraction * width);
  if (begin == -y) {  // without a left wall all cells have the same width
    for (std::size_t n = 0; n < breaks.size(); ++n) {
      breaks[n] = width * static_cast<double>(n) / cells;
    }
  }
  for (double& at : breaks) at += begin;
  breaks.front() = begin;
  breaks.back() = end;
  return numerics::SplineBasis(std::move(breaks));
}

DisplacementBoundaryTypes find_displacement_end_types(
    const numerics::SplineBasis& displacement_basis, const problem::System& system) {
  const double begin = displacement_basis.breaks().front(), end = displacement_basis.end();
  return {.has_left_wall = system.left_wall().has_value(),
          .has_right_wall = system.right_wall().has_value(),
          .is_left_end_open = !system.left_wall() || system.left_wall()->position < begin,
          .is_right_end_open = !system.right_wall() || system.right_wall()->position > end};
}

ImpactSplineBasis make_velocity_spline_basis(const SplineGrid& grid,
                                             const ResidualWeightFunctionOfEnergy& weight,
                                             double restitution) {
  // Without impact losses the splines of the velocity v end at v = -u, where v^2/2 = edge_energy
  // h0, with energy scale h0. Impact losses require splines up to a larger impact speed u, since
  // the energy G must also be large at the velocity v = r u after the impact.
  const double u =
      std::sqrt(2 * grid.edge_energy * weight.energy_scale) / std::pow(restitution, 0.85);
  return ImpactSplineBasis(
      numerics::SplineBasis(numerics::graded_break_points(
          u, grid.speed_cell_count, grid.finest_fraction * u, grid.uniform_from_fraction * u)),
      restitution);
}

BoundWidthLimitingFeature bound_width_limiting_feature(const StationaryFunctional& functional) {
  if (!integrand_breakpoints(functional).empty()) return BoundWidthLimitingFeature::bin_knots;
  const PowerMoment* const mean = std::get_if<PowerMoment>(&functional);
  return mean != nullptr && mean->power > 2 ? BoundWidthLimitingFeature::tails
                                            : BoundWidthLimitingFeature::conical_point;
}

std::span<const SplineGrid> spline_grid_sequence(BoundWidthLimitingFeature feature) {
  // The certificate V has a conical point at the origin of the phase plane. Smaller spline cells at
  // the origin reduce the error of V as long as the error from the cells at the origin dominates.
  // On finer spline grids than those of this list, rounding in the normal equations loses more
  // accuracy than smaller cells gain.
  static constexpr SplineGrid kConicalPointGrids[] = {
      {16, 16, 3e-3, 0.3, 7},   {22, 22, 1e-3, 0.2, 7.5},    {28, 28, 3e-4, 0.2, 8},
      {40, 40, 6e-5, 0.2, 8},   {56, 56, 1.5e-5, 0.15, 8.5}, {64, 64, 6e-6, 0.15, 8},
      {72, 72, 2.5e-6, 0.15, 8}};
  // For moments of powers above 2 the normal equations lose digits already on coarser spline grids
  // than for the powers 1 and 2. The last spline grids for moments of powers above 2 therefore have
  // wider cells at the origin and a larger box than the last grids of kConicalPointGrids.
  static constexpr SplineGrid kTailGrids[] = {kConicalPointGrids[0],    kConicalPointGrids[1],
                                              kConicalPointGrids[2],    kConicalPointGrids[3],
                                              kConicalPointGrids[4],    {56, 56, 6e-5, 0.1, 9.5},
                                              {64, 64, 3e-5, 0.12, 9.5}};
  // The motion transports the knots of a smooth bin through the whole phase plane, therefore the
  // widths of the spline cells vary little.
  static constexpr SplineGrid kBinKnotGrids[] = {{20, 28, 3e-2, 0.1, 6},
                                                 {28, 40, 3e-2, 0.1, 6},
                                                 {36, 50, 3e-2, 0.1, 6},
                                                 {50, 70, 2e-2, 0.1, 6},
                                                 {64, 90, 1e-2, 0.1, 6}};
  switch (feature) {
    case BoundWidthLimitingFeature::conical_point:
      return kConicalPointGrids;
    case BoundWidthLimitingFeature::tails:
      return kTailGrids;
    default:
      return kBinKnotGrids;
  }
}

}  // namespace fpkcheck::backward
