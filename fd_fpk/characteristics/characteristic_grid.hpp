#pragma once

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Returns the grid of cells for characteristics, with all cell widths divided by
/// options.refinement. The cell widths of a characteristic grid follow one of two rules. In case 1
/// with restitution 0.3, the rule for problems without linearised scales would triple the error
/// estimate.
///
/// First rule, for problems with has_linearised_scales(): far from the origin the cell width is a
/// fifth of the typical amplitude. Nearer to the origin the cell width is a constant fraction of
/// the distance to the origin, down to uniform_cell_radius_at_rest_point(). The cells in v are also
/// narrow at atoms of the impulse law and at steps of the density of the law.
///
/// Second rule, for all other problems: far from rest points the cell width in v is a fifth of the
/// typical speed. The cell width in y is dy = v dv / |g|, the displacement for the width dv at
/// constant energy, with the restoring force g. Towards rest points the cell widths decrease in
/// proportion to the distance. Towards a rest point in contact with a wall the cell width in y
/// decreases as the square of v.
PhasePlaneGrid characteristic_grid(const problem::Problem& problem,
                                   const problem::MotionScales& scales,
                                   const FiniteVolumeOptions& options, const PhasePlaneBox& box);

/// Returns the initial computational box for characteristics. A larger computational box than
/// necessary costs little, since cells far from rest points are wide.
PhasePlaneBox initial_characteristic_box(const problem::Problem& problem,
                                         const problem::MotionScales& scales,
                                         const FiniteVolumeOptions& options);

}  // namespace fpkcheck::fd_fpk
