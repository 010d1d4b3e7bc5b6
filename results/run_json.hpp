#pragma once

#include <iosfwd>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Version of the schema of summary.json.
inline constexpr int kSummarySchema = 1;

/// Returns the text of summary.json, the result of a run without curves and joint densities.
/// Numbers that are infinite or NaN become null. For a solution without a density, the moments,
/// mass, minimum density and energy residual become null.
/// @param files checksums of the other files of the saved run
std::string run_summary_text(const Run& run, std::span<const FileChecksum> files = {});

/// Reads the result of a run from a summary.json, with solutions without densities. The JSON type
/// of the value of a metric determines the kind of the metric (metrics_from_json). Solutions from
/// files of an older version have an empty `family`.
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line, if the text is not a summary of this schema, or
///         has a missing or invalid field
Run read_run_summary(std::istream& in, const std::string& file_name);

}  // namespace fpkcheck::results
