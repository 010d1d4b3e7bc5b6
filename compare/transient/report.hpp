#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/transient/run.hpp"

namespace fpkcheck::compare {

/// Version of the shape of transient_json.
inline constexpr int kTransientSchema = 1;

/// Everything a density over time tells but the marginals: program, case, options, status, counts,
/// and what holds at each snapshot.
nlohmann::ordered_json transient_json(const TransientRun& run);

/// The terminal table: a line of parameters, a row a snapshot (thinned evenly when there are many),
/// and the reason when the status is not ok. Plain ASCII.
/// @param width characters per line of the texts; rows take 78
std::string transient_table(const TransientRun& run, std::size_t width);

/// The name under which a case's picture over time is filed in figures/, without extension.
std::string transient_picture_stem(const std::string& case_name);

/// Writes transient.nc and figures/transient-CASE.png, .svg and .gp into a directory that
/// make_writable prepared. Each file is either whole or absent; those of an earlier run of the case
/// do not stay when there is nothing to put in their place.
/// @param gnuplot the program that draws
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws std::runtime_error when a file cannot be written
std::vector<std::string> write_transient(const std::filesystem::path& directory,
                                         const TransientRun& run,
                                         const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::compare
