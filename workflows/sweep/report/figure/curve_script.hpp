#pragma once

#include <string>
#include <vector>

#include "report/figure/legend_strip.hpp"
#include "report/figure/panel_grid.hpp"
#include "workflows/sweep/report/figure/curve_data.hpp"

/// Parts that the scripts of all curves share.
namespace fpkcheck::sweep {

/// Plot of a method's curve in a panel; over words there are marks without a line.
std::string curve_plot(const CurveData& data, std::size_t slice, std::size_t m, int column);

/// The legend of these methods, and of open marks if there are any.
report::Legend curves_legend(const CurveData& data, const std::vector<std::size_t>& methods,
                             bool has_open_marks);

/// Grid of two panels for each slice, above the legend; in a narrow figure one below the other.
report::PanelGrid curves_grid(const CurveData& data, const report::Legend& legend);

/// Beginning of the script: output, data, and settings that all panels share.
std::string curves_begin(const CurveData& data, const report::PanelGrid& grid,
                         const std::string& file_stem);

/// Title ("(a) displacement, gaussian") and margin_commands of a panel.
std::string curves_panel(const CurveData& data, const report::PanelGrid& grid, std::size_t slice,
                         transform::Variable variable);

}  // namespace fpkcheck::sweep
