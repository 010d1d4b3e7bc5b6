#pragma once

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// The grid of cells for characteristics. All cell widths are divided by options.refinement. There
/// are two rules for the cell widths. The second rule applies to every problem, but for problems
/// with has_linearised_scales() its error estimate is three times that of the first rule (case 1
/// with r = 0.3).
///
/// First rule, for problems with has_linearised_scales(): far from the origin the cell width is a
/// fifth of the typical amplitude. Nearer to the origin the cell width is a constant fraction of
/// the distance to the origin, down to relative_core_width(). In v the cells are narrow also at the
/// amplitudes at which the impulse law has an atom or a step of its density, since an impulse gives
/// these speeds to mass at rest. The typical amplitude is that of equivalent linearisation, or, if
/// larger, the amplitude of the motion after half an impulse.
///
/// Second rule, for motion between arbitrary walls, with rest in equilibria and in contact: far
/// from rest points the cell width in v is a fifth of the typical speed. The cell width in y is the
/// displacement that corresponds to the width dv at constant energy, dy = v dv / |g|, with g the
/// restoring force. Towards rest points the cell widths decrease in proportion to the distance;
/// towards a rest point in contact the width in y decreases as the square of v. In cells of the
/// minimum width the motion is practically at rest.
Grid characteristic_grid(const problem::Problem& problem, const problem::MotionScales& scales,
                         const Options& options, const Box& box);

/// The box in which the density is computed first. The box is larger than needed, because its cells
/// far from the rest points are wide and therefore few.
Box initial_characteristic_box(const problem::Problem& problem, const problem::MotionScales& scales,
                               const Options& options);

}  // namespace fpkcheck::fd_fpk
