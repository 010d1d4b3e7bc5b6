#pragma once

#include <optional>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::paper {

/// Distance between a closure and the simulation in one variable, from the error budget.
struct Distance {
  double l1 = 0;
  /// compare::BudgetRow::total_tail; infinite where the closure is 0 in part of the tail, NaN where
  /// no bin of the tail is resolved.
  double tail = 0;
  double l1_error = 0;  ///< error estimate of the reference
  /// Distance in the tail between finite volumes and the simulation, which solve the same problem;
  /// 0 where the budget lacks it.
  double tail_error = 0;
};

/// @param order order of the paper's closure
/// @param missing set to the reason where there is no distance
/// @return empty without the closure, its density, or a reference of sufficient accuracy
///         (workflows/paper/criteria.hpp)
std::optional<Distance> distance_to_simulation(const results::Case& one, int order,
                                               transform::Variable variable, std::string& missing);

/// The maximum of each number of two distances.
Distance maximum_of_each(const Distance& one, const Distance& other);

}  // namespace fpkcheck::paper
