#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/pending_files.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Names of the files of a saved run.
inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr const char* kMarginalsFile = "marginals.csv";
inline constexpr const char* kSmoothMarginalsFile = "smooth.csv";
inline constexpr const char* kJointFile = "joint.nc";

/// Adds the files of a run to `files`, which replace the files of an earlier run in the directory.
/// The files are marginals.csv, smooth.csv (if there are curves over smooth bins), joint.nc (if a
/// solution has a joint density), and summary.json with the checksums of the other files. If this
/// run has no smooth.csv or no joint.nc, that file of an earlier run is removed.
/// @throws std::runtime_error when a file cannot be written
void add_run_files(base::PendingFiles& files, const std::filesystem::path& directory,
                   const Run& run);

/// Adds the files of a run as add_run_files() does, but without joint.nc.
void add_summary_and_curves(base::PendingFiles& files, const std::filesystem::path& directory,
                            const Run& run);

/// Reads a summary.json, of any file name. If a run was killed while its files were moved into the
/// directory of `file`, this function finishes the move first.
/// @throws InputError with a message of one line, if there is no such file
/// @throws the exceptions of read_summary() and base::complete_interrupted_commit()
Run load_summary(const std::filesystem::path& file);

/// Reads the curves of a marginals.csv into the cases of a run.
/// @throws InputError with a message of one line, if there is no such file, if the file contains no
///         marginals, or if the marginals are those of another run. The marginals are those of
///         another run if the checksum differs from that in the summary
void load_curves(const std::filesystem::path& file, Run& run);

/// Reads the curves of a smooth.csv into the cases of a run, as load_curves(). Some solutions may
/// have no curves over smooth bins.
void load_smooth_curves(const std::filesystem::path& file, Run& run);

/// Reads the files of a run that add_run_files() wrote. A run of an older version has no joint
/// densities and no curves over smooth bins.
/// @throws InputError with a message of one line, if the directory contains no run, a file is
///         invalid or has another schema, or the marginals or joint densities are those of another
///         run
Run load_run(const std::filesystem::path& directory);

/// CRC-32 checksum of the bytes of a file, as eight hexadecimal digits. A run identifies its files
/// by their checksums. The checksum skips carriage returns, since version control may change line
/// ends.
std::string crc32(std::string_view bytes);

/// Names and versions of the libraries that write files. For netCDF, the version of the loaded
/// library; for nlohmann-json, the version of the headers that the program was compiled with.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::results
