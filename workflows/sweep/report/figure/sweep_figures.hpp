#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

struct SweepFigure {
  std::string stem;     ///< stem of the file names, e.g. "sweep-map"
  std::string caption;  ///< description of the figure in sentences
  std::string script;
};

/// Returns the figures of a sweep: curves for one varied key, maps for two keys, and scatter plots
/// for three or more keys.
std::vector<SweepFigure> sweep_figures(const SweepResults& results,
                                       report::FigureWidth width = report::FigureWidth::screen);

/// Writes the script STEM.gp of each figure, draws the figure, and removes figures that belong to
/// another plan.
/// @return a warning for each picture that was not drawn; a single warning if gnuplot is missing
std::vector<std::string> draw_sweep_figures(const std::filesystem::path& figures,
                                            const std::vector<SweepFigure>& pictures,
                                            const report::FigureOptions& options = {},
                                            const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
