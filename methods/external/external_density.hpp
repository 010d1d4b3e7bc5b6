#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "methods/external/density_quadrature.hpp"
#include "methods/method_interface.hpp"

/// Methods that return an external density, from a file or from Python, instead of solving an
/// equation. An external density with a stated density equation has the role of a closure: the
/// external density has an error budget. An external density is the reference only on request.
namespace fpkcheck::methods {

struct ExternalDensity {
  std::string label;  ///< id of the solution (methods/external/external_labels.hpp)
  /// Density equation that the external density approximates; empty if unknown. Without a stated
  /// density equation, an external density has no error budget.
  std::optional<problem::DensityEquation> equation = {};
  problem::ImpactCondition impact = problem::ImpactCondition::map;
  std::size_t index = 0;          ///< index among all external densities, for plot styles
  std::optional<int> order = {};  ///< closure order of the density, if known
  /// Whether the density is the reference of the comparison, whatever its error.
  bool is_reference = false;
};

/// Returns the identity of the solution for an external density.
/// @param method transform::kExternalFile or transform::kExternalFunction
/// @param origin phrase on the origin of the density for glossaries: "given as a function"
transform::SolutionIdentity make_external_density_identity(const ExternalDensity& external,
                                                           std::string_view method,
                                                           const std::string& origin);

struct JointDensityOptions {
  /// Whether to divide the density by its integral, which becomes the metric "normalised_by".
  bool normalise = true;
  /// Largest residual-based L1 error estimate of p(y) and p(y') for the status `ok`. The limit
  /// `accuracy` has no effect on an external density whose density equation is unknown.
  double accuracy = 0.02;
  /// Reason for the status `inadmissible` of the external density; empty if no reason is known yet.
  std::string inadmissible_reason = {};
};

/// Returns a method whose solution is an external joint density, stored as averages over cells. The
/// status of the solution is `inadmissible` if values of the density are negative, if the density
/// is not negligible at an outermost edge without a wall, or if the integral of the density differs
/// from 1 and normalisation is not requested.
/// @param values values of the density, row-major, shape (points.y_points(), points.v_points())
/// @throws InputError if a value is not finite, or the integral is not positive
Method make_method_from_density_values(const ExternalDensity& external,
                                       const JointDensityOptions& options,
                                       const DensityQuadratureGrid& points,
                                       std::vector<double> values);

/// If the oscillator may be at rest in contact with a wall, adds a note to the results: an external
/// density does not contain the probability of rest.
void add_rest_atom_note(const problem::Problem& problem, transform::SolverMetricsBuilder& builder);

/// Checks the values of an external joint density.
/// @return the integral of the external density
/// @throws InputError if a value is not finite, or the integral is not positive
double validated_density_integral(const ExternalDensity& external,
                                  const DensityQuadratureGrid& points,
                                  const std::vector<double>& values);

/// @param values values of the density, accepted by validated_density_integral()
/// @param mass integral of the density, from validated_density_integral()
transform::Solution make_external_density_solution(const problem::Problem& problem,
                                                   const SolverInputContext& context,
                                                   const ExternalDensity& external,
                                                   const JointDensityOptions& options,
                                                   const DensityQuadratureGrid& points,
                                                   std::vector<double> values, double mass);

}  // namespace fpkcheck::methods
