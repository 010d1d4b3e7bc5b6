#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/external/argument.hpp"
#include "methods/external/external_density.hpp"
#include "methods/external/file_content.hpp"
#include "methods/external/number_table.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// A joint density from a file: its origin and its values at given points.
struct ExternalJoint {
  std::string path;
  std::string form;         ///< "joint points", "joint cells", "closed form"
  std::size_t numbers = 0;  ///< number of points, cells or coefficients
  std::vector<std::string> notes{};
  bool normalise = true;              ///< as in DensityOptions
  std::string inadmissible_reason{};  ///< as in DensityOptions
  /// The problem of the file, and the equation, impact and order that the file states.
  std::optional<problem::Problem> problem{};
  std::optional<problem::Equation> equation{};
  std::optional<problem::Impact> impact{};
  std::optional<int> order{};
  /// The values at the points: row-major, shape (points.y(), points.v()).
  std::function<std::vector<double>(const problem::Problem&, const DensityPoints&)> values{};
};

/// Reads a joint density from columns of text, from netCDF, or from a closed form as JSON.
/// @throws InputError on one line
ExternalJoint joint_from_table(const NumberTable& table);
ExternalJoint joint_from_netcdf(const ExternalArgument& argument, std::string bytes,
                                const std::string& default_case, const Registry& registry);
ExternalJoint joint_from_json(const ExternalArgument& argument, const std::string& text,
                              const std::string& default_case);

/// The method whose solution is this density.
Method make_joint_method(const ExternalDensity& external, const ExternalJoint& joint);

}  // namespace fpkcheck::methods
