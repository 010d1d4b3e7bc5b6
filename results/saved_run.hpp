#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/file_transaction.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr const char* kMarginalsFile = "marginals.csv";
inline constexpr const char* kSmoothMarginalsFile = "smooth.csv";
inline constexpr const char* kJointFile = "joint.nc";

/// Adds the files of a run to the transaction `files`, which replaces the files of an earlier run
/// in the directory. The files are marginals.csv, smooth.csv (for curves over smooth bins),
/// joint.nc (for joint densities), and summary.json with the checksums of the other files. If this
/// run has no smooth.csv or no joint.nc, the transaction removes this file of the earlier run.
/// @throws std::runtime_error if a file cannot be written
void add_run_files(base::FileTransaction& files, const std::filesystem::path& directory,
                   const Run& run);

/// Adds all files of add_run_files() except joint.nc to the transaction `files`.
void add_summary_and_curves(base::FileTransaction& files, const std::filesystem::path& directory,
                            const Run& run);

/// Reads the summary of a run from a file of any name. If an earlier process was killed while it
/// moved files into the directory of `file`, the function first completes the move.
/// @throws InputError with a message of one line, if the file does not exist
/// @throws all exceptions of read_run_summary() and base::recover_interrupted_commit()
Run load_run_summary(const std::filesystem::path& file);

/// Reads the curves of a marginals.csv into the cases of a run.
/// @throws InputError with a message of one line, if the file does not exist, contains no
///         marginals, or belongs to another run (its checksum differs from the checksum in the
///         summary)
void load_marginal_curves(const std::filesystem::path& file, Run& run);

/// Reads the files that add_run_files() wrote. Runs of older program versions lack joint densities
/// and curves over smooth bins.
/// @throws InputError with a message of one line, if the directory contains no run, or if a file is
///         invalid, has another schema or belongs to another run
Run load_run(const std::filesystem::path& directory);

/// Returns the CRC-32 checksum of bytes, as eight hexadecimal digits. The checksum ignores carriage
/// returns, since version control may change line ends.
std::string crc32_hex(std::string_view bytes);

/// Returns the names and versions of the libraries that write files. The version of netCDF is the
/// version of the loaded library. The version of nlohmann-json is the version of the headers at
/// compile time.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::results
