#pragma once

#include <iosfwd>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Version of the shape of summary.json.
inline constexpr int kSummarySchema = 1;

/// The contents of summary.json: everything a run found but its curves and joint densities.
/// A number that is not finite becomes null, and so do the moments, the mass and the energy
/// residual of a solution without a density.
/// @param files that are saved beside it
std::string summary_text(const Run& run, std::span<const FileChecksum> files = {});

/// Reads what summary_text wrote. The solutions have no densities; kinds of observations are those
/// that their form tells. Runs that were written before solutions carried their identities are read
/// too: then `family` is empty.
/// @param where how messages name the file
/// @throws InputError on one line: broken JSON, not a summary, another schema, a field that is
///         missing or wrong
Run read_summary(std::istream& in, const std::string& where);

}  // namespace fpkcheck::results
