#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

/// Registered methods that a study compares, including variants that no family lists as members.
namespace fpkcheck::study {

/// Set of methods that differ only in their order n, e.g. a formulation of a closure.
struct MethodVariant {
  /// Name of the variant for users, e.g. "moment-white": the stem of the ids. For the first solver
  /// of a role the name omits the prefix "SOLVER-".
  std::string name;
  std::string stem;       ///< common stem of the ids STEM-nN, or id of a method without an order
  bool usual;             ///< whether the variant is a default variant of its family
  methods::Method first;  ///< first method of the variant in the registry

  const transform::SolutionIdentity& identity() const { return first.identity; }
  bool solves_full_problem() const;  ///< returns whether the equation is `kf` with the exact impact
};

/// Returns the method variants of a role, by increasing trust. The default variants of each family
/// come before variants with another value of one option (equation, tail of the exponent).
std::vector<MethodVariant> method_variants(const methods::SolverRegistry& registry,
                                           transform::SolutionRole role);

/// Returns the closures and simulations that are compared with finite volumes for one equation, by
/// increasing trust. A family of closures contributes its default variant if this variant solves
/// the equation. For the equation of the full problem every family contributes its default variant,
/// since every closure approximates the full problem. For other equations the family contributes a
/// variant that solves the equation. The orders are 2, 4, .. 12. For the impact to first order the
/// orders are 2, 4, 6, since closures of higher orders rarely have a density.
/// @param simulation values that replace the default options of simulations
/// @throws InputError if a value of an option is invalid
std::vector<methods::Method> methods_compared_with_grids(const methods::SolverRegistry& registry,
                                                         problem::DensityEquation equation,
                                                         problem::ImpactCondition impact,
                                                         const base::Values& simulation);

}  // namespace fpkcheck::study
