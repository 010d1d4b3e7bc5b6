#pragma once

#include <string>
#include <vector>

#include "report/figure/legend_strip.hpp"
#include "report/figure/panel_grid.hpp"
#include "workflows/sweep/report/figure/curve_data.hpp"

/// What the scripts of curves share.
namespace fpkcheck::sweep {

/// A method's curve in a panel; words are no neighbours, so that nothing joins them.
std::string curve_plot(const CurveData& data, std::size_t slice, std::size_t m, int column);

/// The legend of these methods; where a mark of them is drawn open, what that means.
report::Legend curves_legend(const CurveData& data, const std::vector<std::size_t>& methods,
                             bool any_open);

/// Two panels a slice, above the legend; one below the other where the picture is narrow.
report::PanelGrid curves_grid(const CurveData& data, const report::Legend& legend);

/// What comes before the panels: output, data, and what they have in common.
std::string curves_begin(const CurveData& data, const report::PanelGrid& grid,
                         const std::string& file_stem);

/// "(a) displacement, gaussian", and where the panel stands.
std::string curves_panel(const CurveData& data, const report::PanelGrid& grid, std::size_t slice,
                         transform::Variable variable);

}  // namespace fpkcheck::sweep
