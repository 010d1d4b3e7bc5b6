#pragma once

#include "results/run.hpp"
#include "workflows/check/claim.hpp"
#include "workflows/check/tolerances.hpp"

/// What a run claims of a case.
namespace fpkcheck::check {

/// "p(y)" or "p(y')".
constexpr const char* density_name(transform::Variable variable) {
  return variable == transform::Variable::ydot ? "p(y')" : "p(y)";
}

/// What every solution has: equation and impact, status, moments, mass, balance of power, smallest
/// density, stated error, and of a simulation what it says of its own errors; and what its solver
/// alone knows. A simulation's moments, mass and balance are judged in standard errors.
Claims solution_claims(const transform::Solution& solution, const Tolerances& tolerances);

/// Adds what a solver alone knows, by what the observations say they are: words must be the same;
/// results are judged relative to themselves, yet to no less than their least scale, and so are
/// coefficients; what has a standard error is judged in those, and so are they, but for those of
/// delicate values. Work, and words for people, are no claims.
/// @param whole the solution; claims of kind `simulated_error` get the power of a standard error
///        as which they go in place of what is allowed
void add_observations(const transform::Observations& observations, const Tolerances& tolerances,
                      const Part& whole);

/// The observations of a run that was read from files, which has values alone: what they are, those
/// of the same solution in the new run say.
transform::Observations described(transform::Observations baseline,
                                  const transform::Observations& now);

/// l1, l2, sup, hellinger, kl and the decades of the tail of every pair. Of a pair with a
/// simulation, l1 alone: by the triangle inequality it moves by no more than the L1 between the two
/// simulations. A kl that is infinite in one of the runs is none: a rounding error in the far tail
/// decides that.
/// @param other the same case of the run that this one is held against
Claims distance_claims(const results::Case& one, const results::Case& other,
                       const Tolerances& tolerances);

/// The error budget of every closure. Where it ends in a simulation that chance has moved, what
/// depends on the simulation is judged by its sampling.
Claims budget_claims(const results::Case& one, const results::Case& other,
                     const Tolerances& tolerances);

/// Every curve: the bin that moved most; of a simulation, the bin that moved most in standard
/// errors, among those known to better than half their density and allowing for their number, and
/// L1.
std::vector<Figure> marginal_figures(const results::Case& baseline, const results::Case& now,
                                     const Tolerances& tolerances);

}  // namespace fpkcheck::check
