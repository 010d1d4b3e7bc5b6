#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// A file that a command adds to those of a run.
struct FileBeside {
  std::string name, text;
};

/// Writes marginals.csv, joint.nc (where a solution has a joint density), summary.json, report.html
/// and figures/ into a directory that results::make_writable prepared. The files replace those of
/// an earlier run together, or not at all; its pictures and joint densities are removed.
/// When the program is told to stop (process/stop.hpp), pictures are left out without a word.
/// @param beside replace theirs together with these
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws std::runtime_error when a file cannot be written
std::vector<std::string> write_report(const std::filesystem::path& directory,
                                      const results::Run& run, const FigureOptions& figures = {},
                                      const std::vector<FileBeside>& beside = {});

/// A report made again from a directory.
struct ReportAgain {
  std::string table;
  std::vector<std::string> warnings;  ///< about pictures, one line each
};

/// The table of a saved run, and its page and pictures made anew; solves nothing.
/// @param directory where the run is saved
/// @param run       what results::load_run read there
/// @param format    of the table
/// @throws std::runtime_error when a file cannot be written
ReportAgain report_again(const std::filesystem::path& directory, const results::Run& run,
                         const TextFormat& format = {}, const FigureOptions& figures = {});

}  // namespace fpkcheck::report
