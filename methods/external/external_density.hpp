#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "methods/external/density_points.hpp"
#include "methods/method.hpp"

/// External densities as methods that solve nothing. A density with an equation is a closure: it is
/// compared with the reference and has an error budget, but is never the reference.
namespace fpkcheck::methods {

/// The description of an external density.
struct ExternalDensity {
  std::string label;  ///< the solution's id (methods/external/label.hpp)
  /// The equation that the density approximates. No value: unknown, without an error budget.
  std::optional<problem::Equation> equation = {};
  problem::Impact impact = problem::Impact::map;  ///< impact condition of the equation
  std::size_t index = 0;                          ///< index among external densities, for figures
  std::optional<int> order = {};                  ///< order of the closure
};

/// The identity of the solution.
/// @param method transform::kExternalFile or transform::kExternalFunction
/// @param origin for the glossary, as "given as a function"
transform::Identity external_identity(const ExternalDensity& external, std::string_view method,
                                      const std::string& origin);

/// Options for the values of a joint density.
struct DensityOptions {
  bool normalise = true;  ///< divide by the integral; the metric "normalised_by" is the divisor
  /// For a density with an equation: largest residual-based L1 error estimate of p(y) and of p(y')
  /// with the status ok.
  double accuracy = 0.02;
  std::string inadmissible_reason =
      {};  ///< known reason for the status inadmissible; empty if none
};

/// A method whose solution is a function, given by its values; the density is stored as averages
/// over the cells of the points. The status is `inadmissible` where values are negative, where the
/// density is cut off at the last edge, or where the integral of an unnormalised density is not 1.
/// @param values row-major, shape (points.y(), points.v())
/// @throws InputError when a value is not finite, or the integral is not positive
Method make_function_method(const ExternalDensity& external, const DensityOptions& options,
                            const DensityPoints& points, std::vector<double> values);

/// Adds the note notes[0]: the mass at rest in contact (problem::Features) is not part of an
/// external density.
void add_rest_note(const problem::Problem& problem, transform::MetricBuilder& builder);

/// The integral of values as passed to make_function_method.
/// @throws InputError as make_function_method
double require_density(const ExternalDensity& external, const DensityPoints& points,
                       const std::vector<double>& values);

/// The solution of the method of make_function_method.
/// @param values that require_density accepts
/// @param mass integral of the values
transform::Solution solution_of(const problem::Problem& problem, const SolveContext& context,
                                const ExternalDensity& external, const DensityOptions& options,
                                const DensityPoints& points, std::vector<double> values,
                                double mass);

}  // namespace fpkcheck::methods
