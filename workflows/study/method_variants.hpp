#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

/// Methods of a solver registry that a study compares. Some of the methods in a study are not
/// default members of their family.
namespace fpkcheck::study {

/// Set of methods that differ only in their order n, e.g. a formulation of a closure.
struct MethodVariant {
  /// Name of the method variant for users, e.g. "moment-white". The name of a method variant is the
  /// stem of its solution ids, without the prefix "SOLVER-" for the first solver of a role such as
  /// closure.
  std::string name;
  std::string stem;         ///< common stem of the ids STEM-nN, or id of a method without an order
  bool is_default_variant;  ///< whether the variant is a default variant of its family
  methods::Method first;    ///< first method of the variant in the registry

  const transform::SolutionIdentity& identity() const { return first.identity; }
  bool solves_full_problem() const;  ///< returns whether the variant solves `kf` with exact impact
};

/// Returns the method variants of a role (e.g. closure or simulation), sorted by increasing trust.
/// In each family the default variants precede variants with a non-default option (equation, tail
/// of the exponent).
std::vector<MethodVariant> method_variants(const methods::SolverRegistry& registry,
                                           transform::SolutionRole role);

/// Returns the closures and simulations that are compared with finite volumes for one equation,
/// sorted by increasing trust. A family of closures contributes its default variant to the
/// comparison if this variant solves the equation. For the equation of the full problem every
/// family contributes its default variant, since every closure approximates the full problem. For
/// any equation other than the full problem, each family contributes a variant that solves this
/// equation. The closure orders are 2, 4, .. 12. With the impact condition to first order in 1-r
/// the closure orders are 2, 4, 6, since higher orders rarely give a density.
/// @param simulation values that replace the default options of simulations
/// @throws InputError if a value of an option is invalid
std::vector<methods::Method> methods_compared_with_grids(const methods::SolverRegistry& registry,
                                                         problem::DensityEquation equation,
                                                         problem::ImpactCondition impact,
                                                         const base::Values& simulation);

}  // namespace fpkcheck::study
