#pragma once

#include <iosfwd>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Version of the schema of summary.json.
inline constexpr int kSummarySchema = 1;

/// The text of summary.json: the result of a run without curves and joint densities. Null replaces
/// numbers that are not finite. Null also replaces the moments, the mass, the minimum density and
/// the energy residual of a solution without a density.
/// @param files checksums of the other files that are saved in the same directory
std::string summary_text(const Run& run, std::span<const FileChecksum> files = {});

/// Reads a summary.json, the text of summary_text(). The solutions of the result have no densities.
/// The kind of each metric follows from its JSON type (metrics_from_json). A run of an older
/// version has solutions without an identity; the `family` of these solutions is empty.
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if the text is not JSON, is not a summary, has
///         another schema, or has a missing or invalid field
Run read_summary(std::istream& in, const std::string& where);

}  // namespace fpkcheck::results
