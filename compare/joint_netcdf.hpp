#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "compare/joint_density.hpp"
#include "compare/run_directory.hpp"

namespace fpkcheck::compare {

/// Writes joint densities as netCDF-4 (an HDF5 file), following the CF conventions. For each case,
/// NAME being its name as picture_stem files it:
///
///     dimensions   solution, y_NAME, ydot_NAME, bounds = 2
///     labels       solution(solution, solution_length): ids, as characters
///     coordinates  y_NAME(y_NAME), ydot_NAME(ydot_NAME): centres of cells; their edges are in
///                  y_NAME_bounds(y_NAME, bounds), ydot_NAME_bounds(ydot_NAME, bounds)
///     densities    p_NAME(solution, y_NAME, ydot_NAME): averages over cells, of single precision;
///                  NaN where a solution has no density
///
/// The attributes of p_NAME hold the case's own name, its system and its impulses; those of the
/// file the command. All is non-dimensional.
/// @param summary summary.json of the run
/// @param joints at least one; all of a case on the same cells
/// @throws std::runtime_error on one line when it cannot be written; the file is then as it was
void write_joint_netcdf(const std::filesystem::path& file, const nlohmann::ordered_json& summary,
                        std::span<const JointDensity> joints);

/// The same, as one of several files that replace others together.
void add_joint_netcdf(PendingFiles& files, const std::filesystem::path& file,
                      const nlohmann::ordered_json& summary, std::span<const JointDensity> joints);

/// Reads what write_joint_netcdf wrote.
/// @throws InputError on one line: the file and what is wrong
std::vector<JointDensity> read_joint_netcdf(const std::filesystem::path& file);

}  // namespace fpkcheck::compare
