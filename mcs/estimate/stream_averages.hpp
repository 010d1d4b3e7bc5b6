#pragma once

#include <vector>

#include "mcs/simulation/simulation.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::mcs {

/// The mean of y^p y'^q in one stream, p and q among kPowers.
double moment(const Simulation& simulation, const StreamRecord& record, int p, int q);

/// The mean of a polynomial of y in one stream. @pre its degree is kHighestPower or less, or
/// 6 or less where the record has general sums
double mean_of(const Simulation& simulation, const StreamRecord& record,
               const numerics::Polynomial& g);

/// The same with the physical y and y' of the problem's frame.
double physical_moment(const Simulation& simulation, const StreamRecord& record, int p, int q);

/// E[y^p y'^q] of every stream, p and q among kPowers, as physical_moment().
std::vector<double> moments(const Simulation& simulation, int p, int q);

/// Power that the impulses of each stream happened to bring beyond its expectation.
std::vector<double> excess_powers(const Simulation& simulation);

/// Var(x) / SE^2 of x = y^p y'^q: how many independent draws tell as much of its mean.
double effective_samples(const Simulation& simulation, int p, int q);

}  // namespace fpkcheck::mcs
