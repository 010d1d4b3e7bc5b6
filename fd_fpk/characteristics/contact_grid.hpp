#pragma once

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// Cells for characteristics of motion between arbitrary walls, with rest in equilibria and in
/// contact. Far out their width in v is a fifth of the typical speed; in y the height gained by a
/// speed increase of that size, dy = v dv / |g|. Towards rest points the widths decrease in
/// proportion to the distance, and in contact in y as the square of v. They have a lower limit,
/// below which the motion is practically at rest. All widths are divided by options.refinement.
Grid contact_grid(const problem::Problem& problem, const problem::Scales& scales,
                  const Options& options, const Box& box);

/// The initial, generous box in which to compute the density.
Box initial_contact_box(const problem::Problem& problem, const problem::Scales& scales,
                        const Options& options);

}  // namespace fpkcheck::fd_fpk
