#pragma once

#include <filesystem>
#include <string>

#include "base/files/pending_files.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Names of the files a run saves what it found in.
inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr const char* kMarginalsFile = "marginals.csv";
inline constexpr const char* kSmoothFile = "smooth.csv";
inline constexpr const char* kJointFile = "joint.nc";

/// Adds marginals.csv, smooth.csv (where marginals are known in smooth bins), joint.nc (where a
/// solution has a joint density; else those of an earlier run are to go) and summary.json to the
/// files that replace those of an earlier run. The summary has the checksums of the others.
/// @throws std::runtime_error when a file cannot be written
void add_run(base::PendingFiles& files, const std::filesystem::path& directory, const Run& run);

/// Adds summary.json, marginals.csv and smooth.csv alone.
void add_summary_and_curves(base::PendingFiles& files, const std::filesystem::path& directory,
                            const Run& run);

/// Reads a summary.json, whatever the file's name. Where a run was killed as it put its files into
/// that directory, they are put there first.
/// @throws InputError on one line: no such file, and as read_summary and base::complete_interrupted_commit
Run load_summary(const std::filesystem::path& file);

/// Reads the curves of a marginals.csv into the cases of a run.
/// @throws InputError on one line: no such file, not marginals, or those of another run, by the
///         summary's checksum where it has one
void load_curves(const std::filesystem::path& file, Run& run);

/// The same of a smooth.csv, for which solutions may have none.
void load_smooth(const std::filesystem::path& file, Run& run);

/// Reads back what add_run wrote; a run of an older version has no joint densities
/// and no smooth bins.
/// @throws InputError on one line: no run there, broken JSON, CSV or netCDF, another schema,
///         marginals or joint densities of another run
Run load_run(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
