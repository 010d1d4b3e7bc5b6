#pragma once

#include <string>
#include <vector>

#include "report/figure/legend_strip.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::sweep {

/// Gnuplot point type of a status that is not ok. The types differ in shape, for print in grey.
int point_type(transform::Status status);
/// Point type of the reference, which has no distance to itself.
inline constexpr int kReferenceMark = 6;  // a circle

/// Legend entries of the marks, which are black on colours, for the statuses that occur.
std::vector<report::LegendEntry> status_legend(const std::vector<transform::Status>& statuses);

/// Gnuplot style of a mark, to follow a plot's data.
std::string mark_style(int point_type, double size = 1);

}  // namespace fpkcheck::sweep
