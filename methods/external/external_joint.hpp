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

struct ExternalJointDensity {
  std::string path;
  std::string form;         ///< "joint points", "joint cells" or "closed form"
  std::size_t numbers = 0;  ///< number of points, cells or coefficients
  std::vector<std::string> notes{};
  bool normalise = true;                      ///< see JointDensityOptions::normalise
  std::string inadmissible_reason{};          ///< see JointDensityOptions::inadmissible_reason
  std::optional<problem::Problem> problem{};  ///< problem that the file states, if any
  /// Density equation that the density file states, if any.
  std::optional<problem::DensityEquation> equation{};
  /// Impact condition that the density file states, if any.
  std::optional<problem::ImpactCondition> impact{};
  std::optional<int> order{};  ///< closure order that the file states, if any
  /// Returns the values of the density at the quadrature points, row-major, shape
  /// (points.y_points(), points.v_points()).
  std::function<std::vector<double>(const problem::Problem&, const DensityQuadratureGrid&)>
      values{};
};

/// @throws InputError with a message of one line
ExternalJointDensity joint_density_from_table(const NumberTable& table);
/// Reads a joint density from an external netCDF-4 file or from the joint.nc of a run.
/// @param default_case name of the case to use if `argument` has no case name
/// @throws InputError with a message of one line
ExternalJointDensity joint_density_from_netcdf(const ExternalDensityArgument& argument,
                                               std::string bytes, const std::string& default_case,
                                               const SolverRegistry& registry);
/// Reads a joint density from a JSON file with a closed form, or from the summary of a run.
/// @param default_case name of the case to use if `argument` has no case name
/// @throws InputError with a message of one line
ExternalJointDensity joint_density_from_json(const ExternalDensityArgument& argument,
                                             const std::string& text,
                                             const std::string& default_case);

Method make_method_from_joint_density(const ExternalDensity& external,
                                      const ExternalJointDensity& joint);

}  // namespace fpkcheck::methods
