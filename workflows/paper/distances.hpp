#pragma once

#include <optional>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::paper {

/// L1 and tail distance between a closure and the simulation in a marginal density, from the error
/// budget.
struct ClosureDistance {
  double l1 = 0;
  /// The tail distance is infinite if the closure is 0 in a part of the tail, and NaN if no bin of
  /// the tail is resolved.
  double tail = 0;
  double l1_error = 0;  ///< L1 error estimate of the reference
  /// Tail distance between finite volumes and the simulation; 0 if the budget lacks this distance.
  double tail_error = 0;
};

/// Returns the distance between the paper's closure of one order and the simulation.
/// @param missing_reason receives the reason if there is no distance
/// @return empty if the case lacks the closure, the density of the closure, or a sufficiently
///         accurate reference (workflows/paper/criteria.hpp)
std::optional<ClosureDistance> closure_distance_to_simulation(const results::CaseResult& one,
                                                              int order,
                                                              transform::StateVariable variable,
                                                              std::string& missing_reason);

/// Returns the larger value of each member (L1 distance, tail distance, errors) of two distances.
ClosureDistance componentwise_maximum(const ClosureDistance& one, const ClosureDistance& other);

/// Returns the L1 distance of a marginal density, in the bins of the curve, to the Gaussian of
/// equivalent linearisation, (25)-(26). The density of y follows from the density of z by (30).
double l1_to_equivalent_linearisation(const results::DensityCurve& curve,
                                      const problem::Problem& problem);

}  // namespace fpkcheck::paper
