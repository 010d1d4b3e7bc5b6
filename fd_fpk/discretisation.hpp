#pragma once

#include <string>

#include "fd_fpk/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The box in which the density is sought.
struct Box {
  double x1_max;
  double x2_max;
};

/// Most cells of a grid: KLU's factors of `kf` then take a few gigabytes.
inline constexpr int kMostCells = 60000;

/// The grid and the excitation on it. The velocity step divides the equation's own length (the jump
/// lattice of `kf`, the regularisation length of `km4`), so the two are chosen together.
struct Discretisation {
  Grid grid;
  Excitation excitation;
  double regularisation_length = 0;  ///< l of km4 as used, else 0
  double jump_spacing = 0;           ///< d of kf as used, else 0
  /// Why there is no such grid and what to do; empty when there is one.
  std::string refusal = {};
};

/// Cells of about 1/7 (x1) and 1/6 (x2) of a deviation of equivalent linearisation, unless the
/// options set their number.
Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box);

/// What the options say of the box, else 6 (x1, beyond the static deflection) and 7 (x2)
/// deviations of equivalent linearisation.
Box initial_box(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
