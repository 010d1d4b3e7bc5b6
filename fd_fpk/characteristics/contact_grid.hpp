#pragma once

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// The grid of cells for characteristics of motion between arbitrary walls, with rest in equilibria
/// and in contact. Far from rest points the cell width in v is a fifth of the typical speed. The
/// cell width in y is the height gained by a speed increase of that size, dy = v dv / |g|. Towards
/// rest points the widths decrease in proportion to the distance; towards a rest point in contact
/// the width in y decreases as the square of v. At the minimum width the motion is practically at
/// rest. All widths are divided by options.refinement.
Grid contact_grid(const problem::Problem& problem, const problem::MotionScales& scales,
                  const Options& options, const Box& box);

/// The box in which the density is computed first; the box is larger than needed.
Box initial_contact_box(const problem::Problem& problem, const problem::MotionScales& scales,
                        const Options& options);

}  // namespace fpkcheck::fd_fpk
