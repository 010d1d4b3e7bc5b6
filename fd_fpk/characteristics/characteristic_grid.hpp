#pragma once

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The grid of cells for characteristics with a single wall at the equilibrium. Far from the origin
/// the cell width is a fifth of the typical amplitude. Nearer to the origin the width is a constant
/// fraction of the distance to the origin, down to relative_core_width(). All widths are divided by
/// options.refinement. In v, cells are also narrow at the speeds that mass at rest gains from
/// atoms, or from steps of the density, of the impulse law. The typical amplitude is that of
/// equivalent linearisation, or the amplitude due to half an impulse if that is larger.
Grid characteristic_grid(const problem::Problem& problem, const Options& options, const Box& box);

/// The box in which the density is computed first. The box is larger than needed, because its cells
/// far from the origin are wide and therefore few.
Box initial_characteristic_box(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
