#pragma once

#include <optional>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::paper {

/// L1 distance and tail distance of a marginal density between a closure and the simulation, from
/// the error budget.
struct ClosureDistanceFromSimulation {
  double l1 = 0;
  /// The tail distance is infinite if the closure density is 0 in a part of the tail, and NaN if no
  /// bin of the tail is resolved in all solutions.
  double tail = 0;
  double l1_error = 0;  ///< L1 error estimate of the reference
  /// Tail distance between the finite-volume solution and the simulation, used as error estimate of
  /// tail distances; 0 if unknown.
  double tail_error = 0;
};

/// Returns the distance between the paper's closure of one order and the simulation.
/// @param missing_reason receives the reason if the distance is missing
/// @return empty if the case lacks the closure, the density of the closure, or a sufficiently
///         accurate reference (workflows/paper/claim_criteria.hpp)
std::optional<ClosureDistanceFromSimulation> closure_distance_to_simulation(
    const results::CaseResult& one, int order, transform::StateVariable variable,
    std::string& missing_reason);

/// Returns the componentwise maximum of two ClosureDistanceFromSimulation objects (L1 distances,
/// tail distances and errors).
ClosureDistanceFromSimulation componentwise_maximum(const ClosureDistanceFromSimulation& one,
                                                    const ClosureDistanceFromSimulation& other);

/// Returns the L1 distance of a marginal density from the Gaussian of equivalent linearisation,
/// equations (25)-(26) of the paper, over the bins of the curve. The density of y follows from the
/// density of z by equation (30) of the paper.
double l1_to_equivalent_linearisation(const results::DensityCurve& curve,
                                      const problem::Problem& problem);

}  // namespace fpkcheck::paper
