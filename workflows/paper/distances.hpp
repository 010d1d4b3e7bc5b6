#pragma once

#include <optional>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::paper {

/// The distance between a closure and the simulation for one marginal density, taken from the error
/// budget.
struct Distance {
  double l1 = 0;
  /// The tail distance compare::ErrorBudgetRow::total_tail: infinite if the closure is 0 in a part
  /// of the tail, NaN if no bin of the tail is resolved.
  double tail = 0;
  double l1_error = 0;  ///< error estimate of the reference
  /// The tail distance between finite volumes and the simulation, which solve the same problem; 0
  /// if the budget lacks this distance.
  double tail_error = 0;
};

/// The distance between the paper's closure of one order and the simulation.
/// @param order order of the closure
/// @param missing set to the reason if there is no distance
/// @return empty if the case lacks the closure, the density of the closure, or a reference of
///         sufficient accuracy (workflows/paper/criteria.hpp)
std::optional<Distance> distance_to_simulation(const results::CaseResult& one, int order,
                                               transform::Variable variable, std::string& missing);

/// Takes the larger value of each member (L1 distance, tail distance, errors) of two distances.
Distance larger_distances(const Distance& one, const Distance& other);

/// The L1 distance, in the bins of a curve, between a marginal density and the marginal density of
/// the Gaussian of equivalent linearisation, (25)-(26). The density of y follows from the density
/// of z by (30).
double l1_to_linearisation(const results::Curve& curve, const problem::Problem& problem);

}  // namespace fpkcheck::paper
