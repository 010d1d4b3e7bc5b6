#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Returns the bytes of a netCDF-4 file (CF conventions) with the joint densities of all cases of a
/// run. The suffix NAME in the names of variables is the `case_file_stem` of the name of the case:
///
///     dimensions   solution, y_NAME, ydot_NAME, bounds = 2
///     labels       solution(solution, solution_length): ids of the solutions, as characters
///     coordinates  y_NAME(y_NAME), ydot_NAME(ydot_NAME): centres of the cells
///     cell edges   y_NAME_bounds(y_NAME, bounds), ydot_NAME_bounds(ydot_NAME, bounds)
///     densities    p_NAME(solution, y_NAME, ydot_NAME): averages of p(y, y') over cells, in single
///                  precision, NaN for a solution without a density
///     errors       source_y2_NAME, source_v2_NAME(solution, y_NAME, ydot_NAME): contributions to
///                  the errors of E[y^2] and E[y'^2] (MomentErrorSource), if the case has error sources
///
/// The attributes of the variable p_NAME are the name of the case and the parameters of the
/// problem. The command line of the run is a global attribute of the netCDF file. All physical
/// quantities in the file are non-dimensional.
/// @param run run that has at least one joint density
/// @throws std::runtime_error with a message of one line
std::string joint_netcdf_bytes(const Run& run);

struct CaseJointDensity {
  std::string case_name;
  JointDensity joint;
};
struct CaseErrorSource {
  std::string case_name;
  MomentErrorSource source;
};
struct JointDensityFileContent {
  std::vector<CaseJointDensity> joints;
  std::vector<CaseErrorSource> sources;
};

/// Returns whether the bytes are a netCDF file with the variables of joint_netcdf_bytes().
bool is_joint_netcdf(const std::string& bytes);

/// @param inspect optional function that checks the bytes of the file before parsing
/// @throws InputError with a message of one line
JointDensityFileContent read_joint_netcdf(
    const std::filesystem::path& file,
    const std::function<void(std::string_view bytes)>& inspect = {});

/// An external joint density from a netCDF-4 file: a variable with two coordinates, whose names
/// identify the displacement y and the velocity y'.
struct NetCdfJointDensityVariable {
  std::string name;
  std::string first_name, second_name;
  std::vector<double> first, second;
  std::vector<double> values;  ///< values of the variable, row-major, shape (first, second)
};

/// Reads the only variable of a netCDF-4 file that has two dimensions and a coordinate for each
/// dimension. The coordinate of a dimension is the variable with the name of the dimension.
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line, if the file is corrupt or does not have exactly
/// one variable with two dimensions and coordinates
NetCdfJointDensityVariable read_external_joint_density_variable(std::string bytes,
                                                                const std::string& file_name);

/// Returns the joint densities p(y, y') of all solutions with a joint density, in the order of the
/// solutions. The cell widths of the joint densities in y and in y' are a tenth of a standard
/// deviation. In y-direction each cell joins two adjacent comparison bins
/// (compare/comparison_bins.hpp), so that histograms of simulations need no interpolation. The cell
/// averages of the joint densities are rounded to single precision, as in joint.nc.
std::vector<JointDensity> joint_densities_on_comparison_cells(
    const compare::ComparisonBins& axes, std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::results
