#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::results {

/// The joint densities of a run as the bytes of a netCDF-4 file (an HDF5 file), following the CF
/// conventions. For each case, NAME being its name as file_stem files it:
///
///     dimensions   solution, y_NAME, ydot_NAME, bounds = 2
///     labels       solution(solution, solution_length): ids, as characters
///     coordinates  y_NAME(y_NAME), ydot_NAME(ydot_NAME): centres of cells; their edges are in
///                  y_NAME_bounds(y_NAME, bounds), ydot_NAME_bounds(ydot_NAME, bounds)
///     densities    p_NAME(solution, y_NAME, ydot_NAME): averages over cells, of single precision;
///                  NaN where a solution has no density
///     errors       source_y2_NAME, source_v2_NAME(solution, y_NAME, ydot_NAME): where the errors of
///                  E[y^2] and E[y'^2] come from (ErrorSource), where they are known
///
/// The attributes of p_NAME hold the case's own name, its system and its impulses; those of the
/// file the command. All is non-dimensional.
/// @param run with at least one joint density
/// @throws std::runtime_error on one line
std::string joint_netcdf(const Run& run);

/// A joint density with the name of its case.
struct JointOfCase {
  std::string case_name;
  JointDensity joint;
};
struct SourceOfCase {
  std::string case_name;
  ErrorSource source;
};
/// All that such a file holds.
struct JointFile {
  std::vector<JointOfCase> joints;
  std::vector<SourceOfCase> sources;
};

/// Whether the bytes of a netCDF file have the variables of such a file. False where they cannot be
/// read.
bool is_joint_netcdf(const std::string& bytes);

/// Reads what joint_netcdf made.
/// @param look shown the file's bytes first; what it throws leaves. May be empty
/// @throws InputError on one line: the file and what is wrong
JointFile read_joint_netcdf(const std::filesystem::path& file,
                            const std::function<void(std::string_view bytes)>& look = {});

}  // namespace fpkcheck::results
