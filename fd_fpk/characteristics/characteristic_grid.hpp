#pragma once

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Cells for characteristics. Far from the origin their width is a fifth of the typical amplitude;
/// nearer by a constant fraction of the distance to the origin, down to relative_core_width(). All
/// widths are divided by options.refinement. In v they are equally narrow at the speeds to which
/// atoms or steps of the impulse law take mass at rest. The typical amplitude is that of equivalent
/// linearisation, or the amplitude due to half an impulse where that is larger.
Grid characteristic_grid(const problem::Problem& problem, const Options& options, const Box& box);

/// The initial, generous box in which to compute the density, with cells that are wide far out.
Box initial_characteristic_box(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
