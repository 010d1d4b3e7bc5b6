#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "methods/external/density_points.hpp"
#include "methods/method.hpp"

/// External densities as methods that solve nothing. An external density for which an equation is
/// stated is a closure: the density is compared with the reference, has an error budget, and is
/// never the reference.
namespace fpkcheck::methods {

/// The description of an external density.
struct ExternalDensity {
  std::string label;  ///< label, the id of the solution (methods/external/labels.hpp)
  /// The equation that the density approximates; empty if unknown. A density with an unknown
  /// equation has no error budget.
  std::optional<problem::Equation> equation = {};
  problem::Impact impact = problem::Impact::map;  ///< impact condition of the equation
  std::size_t index = 0;          ///< index among all external densities, for plot styles
  std::optional<int> order = {};  ///< order of the closure
};

/// The identity of the solution that is an external density.
/// @param method transform::kExternalFile or transform::kExternalFunction
/// @param origin phrase on the origin of the density, for the glossary: "given as a function"
transform::SolutionIdentity external_identity(const ExternalDensity& external,
                                              std::string_view method, const std::string& origin);

/// Options for an external joint density.
struct JointDensityOptions {
  /// Whether to divide the density by its integral. The metric "normalised_by" is the divisor.
  bool normalise = true;
  /// Largest residual-based L1 error estimate of p(y) and of p(y') with which the status is ok. Has
  /// no effect on a density with an unknown equation.
  double accuracy = 0.02;
  /// Reason for the status inadmissible, if that status is known; else empty.
  std::string inadmissible_reason = {};
};

/// A method whose solution is an external joint density, given by its values at quadrature points.
/// The solution stores averages over the cells of the points. The status is `inadmissible` if
/// values are negative, if the density is cut off at an outermost edge, or if the integral of a
/// density that is not to be normalised differs from 1.
/// @param values values of the density, row-major, shape (points.y_points(), points.v_points())
/// @throws InputError when a value is not finite, or the integral is not positive
Method make_method_from_density_values(const ExternalDensity& external,
                                       const JointDensityOptions& options,
                                       const DensityPoints& points, std::vector<double> values);

/// Adds the metric notes[0] if mass may be at rest in contact (problem::ProblemFeatures). The note
/// states that an external density does not contain this mass.
void add_rest_atom_note(const problem::Problem& problem, transform::MetricBuilder& builder);

/// Tests the values of an external joint density, as make_method_from_density_values() does.
/// @return the integral of the density
/// @throws InputError when a value is not finite, or the integral is not positive
double validated_density_integral(const ExternalDensity& external, const DensityPoints& points,
                                  const std::vector<double>& values);

/// The solution of a method of make_method_from_density_values().
/// @param values values of the density that validated_density_integral() accepts
/// @param mass integral of the density, the result of validated_density_integral()
transform::Solution external_density_solution(const problem::Problem& problem,
                                              const SolveContext& context,
                                              const ExternalDensity& external,
                                              const JointDensityOptions& options,
                                              const DensityPoints& points,
                                              std::vector<double> values, double mass);

}  // namespace fpkcheck::methods
