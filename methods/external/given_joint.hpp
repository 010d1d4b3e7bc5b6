#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/external/argument.hpp"
#include "methods/external/file_content.hpp"
#include "methods/external/number_table.hpp"
#include "methods/external/own_density.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// A joint density from a file: its origin and its values at given points.
struct GivenJoint {
  std::string path;
  std::string form;         ///< "joint points", "joint cells", "closed form"
  std::size_t numbers = 0;  ///< number of points, cells or coefficients
  std::vector<std::string> notes{};
  bool normalise = true;    ///< as in DensityOptions
  std::string objection{};  ///< as in DensityOptions
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
GivenJoint joint_of_table(const NumberTable& table);
GivenJoint joint_of_netcdf(const GivenArgument& argument, std::string bytes,
                           const std::string& usual_case, const Registry& registry);
GivenJoint joint_of_json(const GivenArgument& argument, const std::string& text,
                         const std::string& usual_case);

/// The method whose solution is this density.
Method method_of(const OwnDensity& own, const GivenJoint& joint);

}  // namespace fpkcheck::methods
