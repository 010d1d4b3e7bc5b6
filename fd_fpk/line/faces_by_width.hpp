#pragma once

#include <functional>
#include <span>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Faces on which all anchors lie, between which cells are about as wide as `width` says where they
/// are, a little less so that they fill each interval.
/// @param anchors increasing, at least two
/// @param width > 0, changing by no more than a part of itself over itself
std::vector<double> faces_by_width(std::span<const double> anchors,
                                   const std::function<double(double)>& width);

}  // namespace fpkcheck::fd_fpk
