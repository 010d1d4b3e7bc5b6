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

/// A joint density from a file: what it is at given points, and what was made of it.
struct GivenJoint {
  std::string path;
  std::string form;         ///< "joint points", "joint cells", "closed form"
  std::size_t numbers = 0;  ///< points, cells or coefficients that it has
  std::vector<std::string> notes{};
  bool normalise = true;    ///< OwnFunction
  std::string objection{};  ///< OwnFunction
  /// That of the file itself, and what it is said to solve there.
  std::optional<problem::Problem> problem{};
  std::optional<problem::Equation> equation{};
  std::optional<problem::Impact> impact{};
  std::optional<int> order{};
  /// Row-major, shape (points.y(), points.v()).
  std::function<std::vector<double>(const problem::Problem&, const DensityPoints&)> values{};
};

/// @throws InputError on one line
GivenJoint joint_of_table(const NumberTable& table);
GivenJoint joint_of_netcdf(const GivenArgument& argument, std::string bytes,
                           const std::string& usual_case, const Registry& registry);
GivenJoint joint_of_json(const GivenArgument& argument, const std::string& text,
                         const std::string& usual_case);

/// The method that takes its values for a problem.
Method method_of(const OwnDensity& own, const GivenJoint& joint);

}  // namespace fpkcheck::methods
