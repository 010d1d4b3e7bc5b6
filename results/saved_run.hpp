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
/// in the directory. The files of a run are marginals.csv, smooth.csv (for curves over smooth
/// bins), joint.nc (for joint densities), and summary.json with the checksums of the other files.
/// For a run without smooth.csv or joint.nc, the transaction removes the smooth.csv or joint.nc of
/// the earlier run.
/// @throws std::runtime_error if a file cannot be written
void add_run_files(base::FileTransaction& files, const std::filesystem::path& directory,
                   const Run& run);

/// Adds all files of add_run_files() except joint.nc to the transaction `files`.
void add_summary_and_curves(base::FileTransaction& files, const std::filesystem::path& directory,
                            const Run& run);

/// Reads the summary of a run from a file of any name. If an earlier process was killed while
/// moving files into the directory of `file`, load_run_summary() first completes the move.
/// @throws InputError with a message of one line, if the file does not exist
/// @throws all exceptions of read_run_summary() and base::recover_interrupted_commit()
Run load_run_summary(const std::filesystem::path& file);

/// Reads the marginal densities of a marginals.csv into the cases of a run.
/// @throws InputError with a message of one line, if the file does not exist, contains no
///         marginals, or belongs to another run (its checksum differs from the checksum in the
///         summary)
void load_marginal_curves(const std::filesystem::path& file, Run& run);

/// Reads the files that add_run_files() wrote. Runs of older program versions lack joint densities
/// and curves over smooth bins.
/// @throws InputError with a message of one line, if the directory contains no run, or if a file is
///         invalid, has another schema or belongs to another run
Run load_run(const std::filesystem::path& directory);

/// Returns the CRC-32 checksum of bytes without carriage returns, as eight hexadecimal digits;
/// version control may add or remove carriage returns.
std::string crc32_hex(std::string_view bytes);

/// Returns the names and versions of the libraries that write files. The version of netCDF is the
/// version of the loaded netCDF library. The version of nlohmann-json is the version of the
/// nlohmann-json headers at compile time.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::results
