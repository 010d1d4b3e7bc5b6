#pragma once

#include <functional>
#include <span>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Faces of an axis that include all anchors. Each cell has about the width that `width` gives at
/// its position; the cells are slightly narrower, so that a whole number of cells fills each
/// interval between anchors.
/// @param anchors positions in increasing order, at least two
/// @param width function that returns the cell width at a position, > 0. The relative change of
/// this function over one cell must be small.
std::vector<double> faces_with_local_width(std::span<const double> anchors,
                                           const std::function<double(double)>& width);

}  // namespace fpkcheck::fd_fpk
