#pragma once

#include <string>
#include <vector>

#include "report/figure/layout.hpp"
#include "workflows/sweep/report/figure/curve_data.hpp"

/// Parts that all gnuplot scripts with curves along a varied key share.
namespace fpkcheck::sweep {

/// The plot specification of a method's curve in a panel. On a categorical axis a curve has marks
/// without a line.
std::string curve_plot_command(const CurveData& data, std::size_t slice, std::size_t m, int column);

/// The legend of the given methods, with an entry for open marks if there are open marks.
report::Legend curves_legend(const CurveData& data, const std::vector<std::size_t>& methods,
                             bool has_open_marks);

/// The panel grid above the legend, with two panels for each slice. In a narrow figure all panels
/// are one below the other.
report::PanelGrid curves_grid(const CurveData& data, const report::Legend& legend);

/// The beginning of a script: output commands, data, and settings that all panels share.
std::string curves_script_beginning(const CurveData& data, const report::PanelGrid& grid,
                                    const std::string& file_stem);

/// The gnuplot commands for title ("(a) displacement, gaussian") and position of a panel.
std::string curves_panel(const CurveData& data, const report::PanelGrid& grid, std::size_t slice,
                         transform::Variable variable);

}  // namespace fpkcheck::sweep
