#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Writes marginals.csv, joint.nc (where a solution has a joint density), summary.json, report.html
/// and figures/ into a directory that results::make_writable prepared. The files replace those of
/// an earlier run together, or not at all; its pictures and joint densities are removed.
/// When the program is told to stop (base/process/stop.hpp), pictures are left out without a word.
/// @param supplement its files replace theirs together with those of the run
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws std::runtime_error when a file cannot be written
std::vector<std::string> write_report(const std::filesystem::path& directory,
                                      const results::Run& run, const FigureOptions& figures = {},
                                      const Supplement& supplement = {});

/// What a terminal shows of a run: the supplement's summary, the tables, the supplement's text.
std::string terminal_text(const results::Run& run, const Supplement& supplement,
                          const TextFormat& format = {});

/// A report made again from a directory.
struct ReportAgain {
  std::string text;                   ///< terminal_text
  std::vector<std::string> warnings;  ///< about pictures, one line each
};

/// The text of a saved run, and its page, its pictures and the files of the supplement made anew;
/// solves nothing.
/// @param directory where the run is saved
/// @param run       what results::load_run read there
/// @param format    of the text
/// @throws std::runtime_error when a file cannot be written
ReportAgain report_again(const std::filesystem::path& directory, const results::Run& run,
                         const TextFormat& format = {}, const FigureOptions& figures = {},
                         const Supplement& supplement = {});

}  // namespace fpkcheck::report
