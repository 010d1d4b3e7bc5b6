#pragma once

#include <iosfwd>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Version of the schema of summary.json.
inline constexpr int kSummarySchema = 1;

/// The contents of summary.json: the result of a run without curves and joint densities. Numbers
/// that are not finite become null, and so do the moments, the mass and the energy residual of a
/// solution without a density.
/// @param files saved in the same directory
std::string summary_text(const Run& run, std::span<const FileChecksum> files = {});

/// Reads a text of summary_text. The solutions have no densities; the kind of each metric follows
/// from its type (metrics_in). In runs of older versions, solutions have no identity: then `family`
/// is empty.
/// @param where the file's name in messages
/// @throws InputError on one line: invalid JSON, not a summary, another schema, a missing or
///         invalid field
Run read_summary(std::istream& in, const std::string& where);

}  // namespace fpkcheck::results
