#pragma once

#include <functional>
#include <span>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Faces that include all anchors, with cells of about the local `width`, slightly narrower so that
/// whole cells fill each interval.
/// @param anchors increasing, at least two
/// @param width cell width at a position, > 0; its relative change over one width must be small
std::vector<double> faces_by_width(std::span<const double> anchors,
                                   const std::function<double(double)>& width);

}  // namespace fpkcheck::fd_fpk
