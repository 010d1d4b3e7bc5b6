#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

/// What the registered methods offer a study, beside the members that a list names.
namespace fpkcheck::study {

/// Methods that differ in nothing but their order n, if they have one.
struct Kind {
  /// What users call it: its stem, of the first solver's without the solver: "moment-white".
  std::string name;
  std::string stem;       ///< ids are STEM-nN, or STEM where there is no order
  bool usual;             ///< what its family has unless it is told otherwise
  methods::Method first;  ///< one of them

  const transform::Identity& identity() const { return first.identity; }
  bool solves_the_problem() const;  ///< with the jumps and the exact impact
};

/// The kinds of a role by increasing trust: of each family the usual ones, then what one choice of
/// an option makes of them: another equation, another tail.
std::vector<Kind> kinds(const methods::Registry& registry, transform::Role role);

/// What stands beside finite differences of an equation: of each family of closures the usual kind,
/// if it solves this equation or this is the equation of the problem itself, which all closures
/// stand for, else one that solves it, at the orders 2, 4, .. 12 (6 where the impact is to first
/// order: beyond, there is hardly ever a density); and the simulations of the equation.
/// @param simulation values that replace the usual options of simulations
/// @return by increasing trust
/// @throws InputError when such values cannot be used
std::vector<methods::Method> other_methods(const methods::Registry& registry,
                                           problem::Equation equation, problem::Impact impact,
                                           const base::Values& simulation);

}  // namespace fpkcheck::study
