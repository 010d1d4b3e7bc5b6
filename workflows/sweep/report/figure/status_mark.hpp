#pragma once

#include <string>
#include <vector>

#include "report/figure/layout.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::sweep {

/// The gnuplot point type that marks a status that is not ok. The point types differ in shape, so
/// that grey print distinguishes them.
int point_type(transform::Status status);
/// The gnuplot point type that marks the reference, which has no distance to itself.
inline constexpr int kReferenceMark = 6;  // a circle

/// The legend entries of the marks for the statuses that occur. The marks are black on a coloured
/// background.
std::vector<report::LegendEntry> status_legend(const std::vector<transform::Status>& statuses);

/// The gnuplot style of a mark, which follows the data in a plot command.
std::string mark_style(int point_type, double size = 1);

}  // namespace fpkcheck::sweep
