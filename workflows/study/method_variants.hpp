#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

/// Registered methods that a study compares, with the variants that no list of members names.
namespace fpkcheck::study {

/// Methods that differ in their order n alone, e.g. a formulation of a closure.
struct MethodVariant {
  /// Name for users: the stem, for the first solver without the solver's name: "moment-white".
  std::string name;
  std::string stem;       ///< the ids are STEM-nN, or STEM without an order
  bool usual;             ///< the default variant of its family
  methods::Method first;  ///< one of these methods

  const transform::Identity& identity() const { return first.identity; }
  bool solves_full_problem() const;  ///< equation `kf` with the exact impact
};

/// The variants of a role by increasing trust: the default variants of each family, then those that
/// one choice of an option makes of them: another equation, another tail.
std::vector<MethodVariant> method_variants(const methods::Registry& registry, transform::Role role);

/// Methods that are compared with finite volumes for an equation: closures and simulations of that
/// equation. Each family of closures contributes its default variant, if this solves the equation
/// or the equation is that of the full problem, which every closure approximates; otherwise a
/// variant that solves the equation. The orders are 2, 4, .. 12; with the impact to first order
/// they are 2, 4, 6, since higher orders rarely have a density.
/// @param simulation values that replace the default options of simulations
/// @return methods by increasing trust
/// @throws InputError when the values are invalid
std::vector<methods::Method> comparison_methods(const methods::Registry& registry,
                                                problem::Equation equation, problem::Impact impact,
                                                const base::Values& simulation);

}  // namespace fpkcheck::study
