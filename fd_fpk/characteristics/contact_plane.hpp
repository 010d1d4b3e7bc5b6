#pragma once

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// Cells for characteristics of a motion with walls anywhere, that comes to rest in equilibria and in
/// contact. In v they are a fifth of the usual speed, in y what a speed larger by so much reaches
/// farther, dy = v dv / |g|; towards places of rest they shrink in proportion to the distance, in contact in
/// y as the square of v, down to where what is left is as good as at rest; all divided by
/// options.refinement.
Grid contact_grid(const problem::Problem& problem, const problem::Scales& scales,
                  const Options& options, const Box& box);

/// Where to look for the density at first.
Box generous_contact_box(const problem::Problem& problem, const problem::Scales& scales,
                         const Options& options);

}  // namespace fpkcheck::fd_fpk
