#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "backward/passage/renewal_equation.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Crossings of a barrier in the stationary process.
struct StationaryCrossings {
  /// Quadrature rule for the velocities v < 0 of downcrossings: the mean number of downcrossings
  /// per unit time, weighted with a function g, is the sum of rates(m) g(velocities[m]).
  std::vector<double> velocities;
  Eigen::VectorXd rates;
  double upcrossing_rate;    ///< mean number of upcrossings per unit time
  double probability_below;  ///< stationary probability of displacements below the barrier
};

/// Computes the crossings of the barrier in the stationary process by collocation. The states
/// before successive impulses are a Markov chain with the operator lambda A on the whole phase
/// plane, where A is the operator of RenewalEquation without a passage:
///
///     (A f)(y, v) = E int_0^infinity exp(-lambda t) f(X_t) dt,   X_0 = (y, v + Y).
///
/// Since impulses arrive at a constant rate, the stationary law of the chain is the stationary law
/// of the process. The discretised law is the left null vector of I - lambda A. A function of the
/// displacement that jumps at the barrier, and the number of crossings, are integrated along
/// trajectories and projected to polynomials in y.
/// @param grid nodes on the whole phase plane, without a barrier at their upper end
/// @param barrier displacement of the barrier, in the domain of the grid
/// @param panel_refinement see RenewalEquation
/// @return an empty value if the deadline passes
/// @pre the problem has no right wall
std::optional<StationaryCrossings> compute_stationary_crossings(const problem::Problem& problem,
                                                                const ChebyshevGrid& grid,
                                                                double barrier,
                                                                double panel_refinement,
                                                                const base::Deadline& deadline);

}  // namespace fpkcheck::backward
