#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::results {

/// The joint densities of a run as the bytes of a netCDF-4 file (an HDF5 file) with the CF
/// conventions. For each case, with NAME the file_stem of its name:
///
///     dimensions   solution, y_NAME, ydot_NAME, bounds = 2
///     labels       solution(solution, solution_length): ids, as characters
///     coordinates  y_NAME(y_NAME), ydot_NAME(ydot_NAME): centres of cells; the edges are
///                  y_NAME_bounds(y_NAME, bounds), ydot_NAME_bounds(ydot_NAME, bounds)
///     densities    p_NAME(solution, y_NAME, ydot_NAME): averages over cells, in single precision;
///                  NaN where a solution has no density
///     errors       source_y2_NAME, source_v2_NAME(solution, y_NAME, ydot_NAME): contributions to
///                  the errors of E[y^2] and E[y'^2] (ErrorSource), where they are known
///
/// The attributes of p_NAME contain the case's name, its system and its impulses; the attributes of
/// the file contain the command. All quantities are non-dimensional.
/// @param run with at least one joint density
/// @throws std::runtime_error on one line
std::string joint_netcdf(const Run& run);

/// A joint density or an error source with the name of its case.
struct CaseJointDensity {
  std::string case_name;
  JointDensity joint;
};
struct CaseErrorSource {
  std::string case_name;
  ErrorSource source;
};
/// The contents of such a file.
struct JointFileContent {
  std::vector<CaseJointDensity> joints;
  std::vector<CaseErrorSource> sources;
};

/// Whether the bytes of a netCDF file have the variables of such a file. False where the bytes
/// cannot be read.
bool is_joint_netcdf(const std::string& bytes);

/// Reads a file that joint_netcdf wrote.
/// @param inspect receives the file's bytes first; its exceptions propagate. May be empty
/// @throws InputError on one line: the file and the problem
JointFileContent read_joint_netcdf(const std::filesystem::path& file,
                                   const std::function<void(std::string_view bytes)>& inspect = {});

}  // namespace fpkcheck::results
