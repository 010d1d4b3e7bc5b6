#pragma once

#include <filesystem>
#include <string>

#include "base/files/pending_files.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Names of the files of a saved run.
inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr const char* kMarginalsFile = "marginals.csv";
inline constexpr const char* kSmoothFile = "smooth.csv";
inline constexpr const char* kJointFile = "joint.nc";

/// Adds the files of a run to the files that replace those of an earlier run: marginals.csv,
/// smooth.csv (where there are curves over smooth bins), joint.nc (where a solution has a joint
/// density) and summary.json, with the checksums of the others. A smooth.csv or joint.nc of an
/// earlier run is removed where this run has none.
/// @throws std::runtime_error when a file cannot be written
void add_run(base::PendingFiles& files, const std::filesystem::path& directory, const Run& run);

/// Adds summary.json, marginals.csv and smooth.csv only.
void add_summary_and_curves(base::PendingFiles& files, const std::filesystem::path& directory,
                            const Run& run);

/// Reads a summary.json; the file may have any name. If a run was killed while it moved its files
/// into that directory, the move is finished first.
/// @throws InputError on one line: no such file; and the exceptions of read_summary and
///         base::complete_interrupted_commit
Run load_summary(const std::filesystem::path& file);

/// Reads the curves of a marginals.csv into the cases of a run.
/// @throws InputError on one line: no such file, not marginals, or marginals of another run (by the
///         checksum, if the summary has one)
void load_curves(const std::filesystem::path& file, Run& run);

/// Reads the curves of a smooth.csv likewise; solutions may lack them.
void load_smooth(const std::filesystem::path& file, Run& run);

/// Reads the files of add_run. A run of an older version has no joint densities and no curves over
/// smooth bins.
/// @throws InputError on one line: no run in the directory, invalid JSON, CSV or netCDF, another
///         schema, marginals or joint densities of another run
Run load_run(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
