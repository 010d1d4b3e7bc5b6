#pragma once

#include <optional>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::paper {

/// How far a closure is from the simulation in one variable, as the error budget has it.
struct Distance {
  double l1 = 0;
  /// compare::BudgetRow::total_tail; infinite where the closure is 0 in part of the tail, NaN where
  /// no bin of it is known well.
  double tail = 0;
  double l1_error = 0;  ///< what the simulation says of its own error
  /// What finite differences and the simulation, which solve the same problem, differ by in the
  /// tail; 0 where the budget does not say.
  double tail_error = 0;
};

/// @param order of the paper's closure
/// @param missing says in words why there is no distance
/// @return nothing without the closure, a density of it, or a reference that knows itself well
///         enough (workflows/paper/criteria.hpp)
std::optional<Distance> distance_of(const results::Case& one, int order,
                                    transform::Variable variable, std::string& missing);

/// The larger of all their numbers.
Distance worse(const Distance& one, const Distance& other);

}  // namespace fpkcheck::paper
