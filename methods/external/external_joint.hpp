#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/external/density_file.hpp"
#include "methods/external/external_argument.hpp"
#include "methods/external/external_density.hpp"
#include "methods/external/number_table.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// An external joint density that was read from a file.
struct ExternalJointDensity {
  std::string path;                             ///< name of the file
  std::string form;                             ///< "joint points", "joint cells", "closed form"
  std::size_t numbers = 0;                      ///< number of points, cells or coefficients
  std::vector<std::string> notes{};             ///< remarks for the user
  bool normalise = true;                        ///< as in JointDensityOptions
  std::string inadmissible_reason{};            ///< as in JointDensityOptions
  std::optional<problem::Problem> problem{};    ///< problem that the file states, if any
  std::optional<problem::Equation> equation{};  ///< equation that the file states, if any
  std::optional<problem::Impact> impact{};      ///< impact condition that the file states, if any
  std::optional<int> order{};  ///< order of the closure that the file states, if any
  /// Function that evaluates the density at quadrature points. The result is row-major, shape
  /// (points.y_points(), points.v_points()).
  std::function<std::vector<double>(const problem::Problem&, const DensityPoints&)> values{};
};

/// Converts columns of numbers to a joint density.
/// @throws InputError with a message of one line
ExternalJointDensity joint_density_from_table(const NumberTable& table);
/// Reads a joint density from a netCDF-4 file, an external file or the joint.nc of a run.
/// @param bytes contents of the file
/// @param default_case name of the case to use if `argument` has no case name
/// @throws InputError with a message of one line
ExternalJointDensity joint_density_from_netcdf(const ExternalArgument& argument, std::string bytes,
                                               const std::string& default_case,
                                               const Registry& registry);
/// Reads a joint density from JSON: a closed form, or the summary of a run.
/// @param text contents of the file
/// @param default_case name of the case to use if `argument` has no case name
/// @throws InputError with a message of one line
ExternalJointDensity joint_density_from_json(const ExternalArgument& argument,
                                             const std::string& text,
                                             const std::string& default_case);

/// A method whose solution is an external joint density from a file.
Method make_method_from_joint_density(const ExternalDensity& external,
                                      const ExternalJointDensity& joint);

}  // namespace fpkcheck::methods
