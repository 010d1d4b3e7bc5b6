#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/figure_options.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Writes sweep.csv and sweep.nc in one transaction. The report page of an earlier sweep is
/// removed, since the page may contradict the new files.
/// @throws std::runtime_error with a message of one line
void write_sweep_tables(const std::filesystem::path& directory, const SweepResults& results,
                        const std::string& command);

/// Draws the figures of a sweep into DIRECTORY/figures in the requested formats, and writes the
/// page report.html. The report page has no pictures if gnuplot is missing.
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error with a message of one line
std::vector<std::string> write_report(const std::filesystem::path& directory,
                                      const SweepResults& results, const std::string& command,
                                      const report::FigureOptions& figures = {},
                                      const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
