#pragma once

#include <string>
#include <vector>

#include "report/figure/legend_strip.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::sweep {

/// Point type of gnuplot for a status that is not ok: they differ in shape, for grey print.
int point_type(transform::Status status);
/// Of the reference, which has no distance to itself.
inline constexpr int kReferenceMark = 6;  // a circle

/// Marks in black on colours, and what they mean: of those statuses that are there.
std::vector<report::LegendEntry> status_legend(const std::vector<transform::Status>& there);

/// How a mark is drawn, after a plot's data.
std::string mark_drawn(int point_type, double size = 1);

}  // namespace fpkcheck::sweep
