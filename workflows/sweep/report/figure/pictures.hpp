#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A picture of a sweep.
struct SweepPicture {
  std::string stem;     ///< of its files: "sweep-map"
  std::string caption;  ///< what it shows, in sentences
  std::string script;   ///< for gnuplot
};

/// What there is to draw: curves along one key, maps over two, points against each of more.
std::vector<SweepPicture> sweep_pictures(const SweepResults& results,
                                         report::FigureWidth width = report::FigureWidth::screen);

/// Draws them beside STEM.gp in the formats that are asked for; those of another plan go.
/// @return a warning for each picture that was not drawn; one when there is no gnuplot
std::vector<std::string> draw_sweep(const std::filesystem::path& figures,
                                    const std::vector<SweepPicture>& pictures,
                                    const report::FigureOptions& options = {},
                                    const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
