#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A figure of a sweep.
struct SweepPicture {
  std::string stem;     ///< stem of its files, e.g. "sweep-map"
  std::string caption;  ///< description in sentences
  std::string script;   ///< gnuplot script
};

/// The figures of a sweep: curves along one key, maps over two, points against each key of more.
std::vector<SweepPicture> sweep_pictures(const SweepResults& results,
                                         report::FigureWidth width = report::FigureWidth::screen);

/// Writes STEM.gp for each figure and draws it in the given formats. Removes figures of other
/// plans.
/// @return a warning for each picture that was not drawn; one when there is no gnuplot
std::vector<std::string> draw_sweep(const std::filesystem::path& figures,
                                    const std::vector<SweepPicture>& pictures,
                                    const report::FigureOptions& options = {},
                                    const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
