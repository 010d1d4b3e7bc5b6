#pragma once

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Returns the grid for transport along characteristics, with all cell widths divided by
/// options.refinement. The cell widths follow one of two rules: in case 1 with the restitution
/// coefficient 0.3 the second rule would triple the error estimate.
///
/// First rule for the cell widths, for problems with has_linearised_scales(): far from the origin
/// the cell width is a fifth of the typical amplitude. Nearer to the origin of the phase plane the
/// cell width is a constant fraction of the distance to the origin, down to
/// uniform_cell_radius_at_rest_point(). The cells in the velocity v are also narrow at atoms of the
/// law of the impulse amplitude and at discontinuities of the density of this law.
///
/// Second rule for the cell widths, for all other problems: far from rest points the cell width in
/// the velocity v is a fifth of the typical speed. The cell width in the displacement y is dy = v
/// dv / |g|, the change of y at constant energy for the cell width dv in v and the restoring force
/// g. Towards rest points the cell widths decrease in proportion to the distance from the rest
/// point. Towards a rest point in contact with a wall the cell width in the displacement decreases
/// as the square of the velocity.
PhasePlaneGrid characteristic_grid(const problem::Problem& problem,
                                   const problem::MotionScales& scales,
                                   const FiniteVolumeOptions& options, const PhasePlaneBox& box);

/// Returns the initial computational box of the phase plane for transport along characteristics. A
/// larger computational box than necessary costs little, since cells far from rest points are wide.
PhasePlaneBox initial_characteristic_box(const problem::Problem& problem,
                                         const problem::MotionScales& scales,
                                         const FiniteVolumeOptions& options);

}  // namespace fpkcheck::fd_fpk
