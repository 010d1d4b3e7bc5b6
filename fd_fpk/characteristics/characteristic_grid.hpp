#pragma once

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// The grid of cells for characteristics. All widths are divided by options.refinement. There are two
/// rules for the widths. The second rule holds for every problem, but states three times the error
/// of the first rule for problems of the first kind (case 1 with r = 0.3).
///
/// With has_linearised_scales(): far from the origin the cell width is a fifth of the typical
/// amplitude. Nearer to the origin the width is a constant fraction of the distance to the origin,
/// down to relative_core_width(). In v, cells are also narrow at the speeds that mass at rest gains
/// from atoms, or from steps of the density, of the impulse law. The typical amplitude is that of
/// equivalent linearisation, or the amplitude due to half an impulse if that is larger.
///
/// For motion between arbitrary walls, with rest in equilibria and in contact: far from rest points
/// the cell width in v is a fifth of the typical speed. The cell width in y is the height gained by
/// a speed increase of that size, dy = v dv / |g|. Towards rest points the widths decrease in
/// proportion to the distance; towards a rest point in contact the width in y decreases as the
/// square of v. At the minimum width the motion is practically at rest.
Grid characteristic_grid(const problem::Problem& problem, const problem::MotionScales& scales,
                         const Options& options, const Box& box);

/// The box in which the density is computed first. The box is larger than needed, because its cells
/// far from the rest points are wide and therefore few.
Box initial_characteristic_box(const problem::Problem& problem, const problem::MotionScales& scales,
                               const Options& options);

}  // namespace fpkcheck::fd_fpk
