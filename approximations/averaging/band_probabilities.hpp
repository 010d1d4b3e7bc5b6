#pragma once

#include <vector>

#include "approximations/averaging/energy_density.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::averaging {

/// Returns the stationary probabilities of the energy bands under impulses, noise, damping and
/// impacts, averaged over the undamped orbits. The probability q(h) per unit energy satisfies, with
/// the energy loss per period W(h), the period T(h) and D v^2 averaged over the orbit,
///
///     d/dh [W/T q] + d/dh [<D G v^2> T d/dh (q / T)] + lambda (mean jumps into h - q) = 0,
///
/// where an impulse Y at a point (y, v) of the orbit changes the energy to (v + b Y)^2/2 + V(y).
/// Between two bands q/T is extrapolated from the side from which the energy loss transports
/// probability, and its derivative is a central difference. The probabilities of jumps are exact
/// for each point of an orbit.
///
/// At an energy where one orbit separates into the orbits of several wells, the energy loss leads
/// into each well in proportion to the energy loss in this well.
std::vector<double> stationary_band_probabilities(const problem::Problem& problem,
                                                  const EnergyLevels& levels);

}  // namespace fpkcheck::averaging
