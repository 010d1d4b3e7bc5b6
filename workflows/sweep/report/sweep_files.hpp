#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Writes sweep.csv and sweep.nc into a directory, either both files or none. The page of an
/// earlier sweep is removed, since its numbers may differ.
/// @param command command line of the sweep
/// @throws std::runtime_error with a message of one line
void write_tables(const std::filesystem::path& directory, const SweepResults& results,
                  const std::string& command);

/// Draws the figures of a sweep into DIRECTORY/figures, in the given formats and as SVG and PNG for
/// the page, and writes the page report.html. The page has no pictures if gnuplot is missing.
/// @return warnings, one line each, with the reasons why pictures could not be drawn
/// @throws std::runtime_error with a message of one line
std::vector<std::string> write_report(const std::filesystem::path& directory,
                                      const SweepResults& results, const std::string& command,
                                      const report::FigureOptions& figures = {},
                                      const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
