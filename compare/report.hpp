#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "compare/case_report.hpp"
#include "compare/joint_density.hpp"
#include "compare/marginals_csv.hpp"
#include "compare/text/format.hpp"

namespace fpkcheck::compare {

/// Names of the files a run saves what it found in.
inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr const char* kMarginalsFile = "marginals.csv";

/// What a run saves; tables and pictures are made from it alone.
struct SavedRun {
  nlohmann::ordered_json summary;
  std::vector<MarginalCurve> marginals;
  std::vector<JointDensity> joints = {};  ///< of the solutions that have one
};

/// True when every solution with a density has its curves and there are no others: summary and
/// marginals are then of the same run.
/// @throws nlohmann::json::exception where the summary lacks what its schema promises
bool marginals_belong(const SavedRun& run);

/// The summary as text. Bytes that are not UTF-8 (a file's name may have any) are replaced.
std::string json_text(const nlohmann::ordered_json& summary);

/// @param command the command line of the run
SavedRun make_run(const std::string& command, std::span<const CaseReport> cases);

/// Writes marginals.csv, joint.nc (where a solution has a joint density), summary.json, report.html
/// and figures/ into a directory that make_writable prepared. The files replace those of
/// an earlier run together, or not at all; its pictures and joint densities are removed.
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws std::runtime_error when a file cannot be written
std::vector<std::string> write_report(const std::filesystem::path& directory, const SavedRun& run);

/// Reads a summary.json, whatever the file's name.
/// @throws InputError on one line: no such file, broken JSON, not a summary, another schema
nlohmann::ordered_json load_summary(const std::filesystem::path& file);

/// Reads back what write_report wrote; a run of an older version has no joint densities.
/// @throws InputError on one line: no run there, broken JSON, CSV or netCDF, another schema
SavedRun load_run(const std::filesystem::path& directory);

/// A report made again from a directory.
struct ReportAgain {
  std::string table;
  std::vector<std::string> warnings;  ///< about pictures, one line each
};

/// The table of a saved run, and its page and pictures made anew; solves nothing.
/// @param format of the table
/// @throws InputError as load_run does, when the marginals or joint densities are of another run,
/// and when the summary lacks what its schema promises: nothing is written then
ReportAgain report_again(const std::filesystem::path& directory, const TextFormat& format = {});

}  // namespace fpkcheck::compare
