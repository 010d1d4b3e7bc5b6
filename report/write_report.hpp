#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/figure_options.hpp"
#include "report/report_supplement.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Writes marginals.csv, joint.nc, summary.json, report.html and figures/ into a directory that
/// results::prepare_output_directory() prepared. The function write_report() replaces either all
/// files of an earlier run in the directory or none of these files. Pictures and joint densities of
/// an earlier run in the directory are removed. After a stop request
/// (base/process/stop_request.hpp) no pictures are drawn and no warning is returned.
/// @param supplement texts and files of a command, written together with the files of the run
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error if a file cannot be written
std::vector<std::string> write_report(const std::filesystem::path& directory,
                                      const results::Run& run, const FigureOptions& figures = {},
                                      const ReportSupplement& supplement = {});

/// Returns the text that the program prints for a run: the summary of the supplement, then the
/// tables of the run, then the text of the supplement.
std::string terminal_report_text(const results::Run& run, const ReportSupplement& supplement,
                                 const TerminalTextFormat& format = {});

struct ReportRebuiltFromFiles {
  std::string text;
  std::vector<std::string> warnings;  ///< warnings about pictures, one line each
};

/// Rebuilds the terminal text of a saved run without solving the problems again. The report page,
/// the pictures and the files of the supplement are written again.
/// @param run run that results::load_run() read from the directory
/// @throws std::runtime_error if a file cannot be written
ReportRebuiltFromFiles rebuild_report(const std::filesystem::path& directory,
                                      const results::Run& run,
                                      const TerminalTextFormat& format = {},
                                      const FigureOptions& figures = {},
                                      const ReportSupplement& supplement = {});

}  // namespace fpkcheck::report
