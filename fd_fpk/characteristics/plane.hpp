#pragma once

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Cells for characteristics: as wide as a fifth of the usual amplitude far from the origin, a
/// constant part of the distance to it nearer by, down to core_at_rest(), all divided by
/// options.refinement; as narrow in v where impulses from rest lead with atoms or up to steps of their
/// law. The usual amplitude is that of equivalent linearisation, or what half an
/// impulse leads to where that is more.
Grid characteristic_grid(const problem::Problem& problem, const Options& options, const Box& box);

/// Where to look for the density at first: far out, in cells that are wide there.
Box generous_box(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
