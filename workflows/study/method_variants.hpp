#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

/// The registered methods that a study compares, including variants that are in no family's list of
/// members.
namespace fpkcheck::study {

/// A set of methods that differ only in their order n, e.g. a formulation of a closure.
struct MethodVariant {
  /// The name for users: the stem of the ids; for methods of the first solver without the name of
  /// the solver: "moment-white".
  std::string name;
  std::string stem;       ///< the ids are STEM-nN, or STEM without an order
  bool usual;             ///< the default variant of its family
  methods::Method first;  ///< one of these methods

  const transform::SolutionIdentity& identity() const { return first.identity; }
  bool solves_full_problem() const;  ///< equation `kf` with the exact impact
};

/// The method variants of a role, by increasing trust. The default variants of each family come
/// first. The variants that differ from a default variant by one choice of an option (another
/// equation, another tail of the exponent) follow.
std::vector<MethodVariant> method_variants(const methods::Registry& registry,
                                           transform::SolutionRole role);

/// The closures and simulations that are compared with finite volumes for one equation. A family of
/// closures contributes its default variant if this variant solves the equation, or if the equation
/// is that of the full problem, which every closure approximates. Otherwise the family contributes
/// a variant that solves the equation. The orders are 2, 4, .. 12. For the impact to first order
/// the orders are 2, 4, 6, since closures of higher orders rarely have a density.
/// @param simulation values that replace the default options of simulations
/// @return methods by increasing trust
/// @throws InputError if a value of an option is invalid
std::vector<methods::Method> comparison_methods(const methods::Registry& registry,
                                                problem::Equation equation, problem::Impact impact,
                                                const base::Values& simulation);

}  // namespace fpkcheck::study
