#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/comparison_axes.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// The bytes of a netCDF-4 file (an HDF5 file) with the joint densities of a run, by the CF
/// conventions. For each case the file contains the following, where NAME is the file_stem of the
/// case's name:
///
///     dimensions   solution, y_NAME, ydot_NAME, bounds = 2
///     labels       solution(solution, solution_length): ids, as characters
///     coordinates  y_NAME(y_NAME), ydot_NAME(ydot_NAME): centres of cells; the edges are
///                  y_NAME_bounds(y_NAME, bounds), ydot_NAME_bounds(ydot_NAME, bounds)
///     densities    p_NAME(solution, y_NAME, ydot_NAME): averages over cells, in single precision;
///                  NaN for a solution without a density
///     errors       source_y2_NAME, source_v2_NAME(solution, y_NAME, ydot_NAME): contributions to
///                  the errors of E[y^2] and E[y'^2] (ErrorSource), if the case has any
///
/// The attributes of p_NAME contain the name of the case and the parameters of its system and of
/// its impulses. The attributes of the file contain the command of the run. All quantities are
/// non-dimensional.
/// @param run a run with at least one joint density
/// @throws std::runtime_error with a message of one line
std::string joint_netcdf(const Run& run);

/// A joint density with the name of its case.
struct CaseJointDensity {
  std::string case_name;
  JointDensity joint;
};
/// The error sources of a solution with the name of its case.
struct CaseErrorSource {
  std::string case_name;
  ErrorSource source;
};
/// The contents of a file of joint densities.
struct JointFileContent {
  std::vector<CaseJointDensity> joints;
  std::vector<CaseErrorSource> sources;
};

/// Whether the bytes are those of a netCDF file with the variables of joint_netcdf(). Bytes that
/// cannot be read give false.
bool is_joint_netcdf(const std::string& bytes);

/// Reads a file with the bytes of joint_netcdf().
/// @param inspect function that receives the bytes of the file before they are read; may be empty.
///        Exceptions of `inspect` propagate
/// @throws InputError with a message of one line: the name of the file and the problem
JointFileContent read_joint_netcdf(const std::filesystem::path& file,
                                   const std::function<void(std::string_view bytes)>& inspect = {});

/// An external joint density from a netCDF-4 file: a variable with two coordinates. The names of
/// the coordinates show which coordinate is y and which is y'.
struct GriddedVariable {
  std::string name;                     ///< name of the variable
  std::string first_name, second_name;  ///< names of the coordinates
  std::vector<double> first, second;    ///< values of the coordinates
  std::vector<double> values;           ///< row-major, shape (first, second)
};

/// Reads the only variable of a netCDF-4 file that has two dimensions and a coordinate for each of
/// them. The coordinate of a dimension is the variable with the name of the dimension.
/// @param bytes contents of the file
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if the file is corrupt, or has no such variable,
///         or has several
GriddedVariable read_gridded_variable(std::string bytes, const std::string& where);

/// The joint densities of all solutions with a joint density, of any status, in the order of the
/// solutions. The widths of the cells are a tenth of a standard deviation in both directions. Each
/// cell joins two adjacent cells of the comparison axes along y, so that the histogram of a
/// simulation is summed and not interpolated. The averages are rounded to single precision, as in
/// joint.nc.
std::vector<JointDensity> joint_densities(const compare::ComparisonAxes& axes,
                                          std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::results
