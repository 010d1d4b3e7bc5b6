#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A figure of a sweep with caption and gnuplot script.
struct SweepPicture {
  std::string stem;     ///< stem of its files, e.g. "sweep-map"
  std::string caption;  ///< description in sentences
  std::string script;   ///< gnuplot script
};

/// The figures of a sweep: curves for one varied key, maps for two varied keys, and scatter plots
/// against each key for more keys.
std::vector<SweepPicture> sweep_pictures(const SweepResults& results,
                                         report::FigureWidth width = report::FigureWidth::screen);

/// Writes the script STEM.gp of each figure, and draws the figure in the given formats. Figures of
/// other plans are removed.
/// @return a warning for each picture that was not drawn; a single warning if gnuplot is missing
std::vector<std::string> draw_sweep(const std::filesystem::path& figures,
                                    const std::vector<SweepPicture>& pictures,
                                    const report::FigureOptions& options = {},
                                    const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
