#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Writes sweep.csv and sweep.nc into a directory, both or none. A page of before goes: it would
/// tell of other numbers.
/// @param command the command line of the sweep
/// @throws std::runtime_error on one line
void write_tables(const std::filesystem::path& directory, const SweepResults& results,
                  const std::string& command);

/// Draws what there is to draw into DIRECTORY/figures, in the formats that are asked for and as the
/// SVG that is put on a page, report.html; without gnuplot the page has no pictures.
/// @return warnings, one line each: pictures that could not be drawn, and why
/// @throws std::runtime_error on one line
std::vector<std::string> write_report(const std::filesystem::path& directory,
                                      const SweepResults& results, const std::string& command,
                                      const report::FigureOptions& figures = {},
                                      const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
