#pragma once

#include "results/run.hpp"
#include "workflows/check/quantity.hpp"
#include "workflows/check/tolerances.hpp"

/// The quantities of a case that two runs are compared by.
namespace fpkcheck::check {

/// "p(y)" or "p(y')".
constexpr const char* density_name(transform::Variable variable) {
  return variable == transform::Variable::ydot ? "p(y')" : "p(y)";
}

/// The quantities that every solution has: equation and impact, status, moments, mass, energy
/// residual, smallest density, error estimate; then its metrics. Of a simulation also the standard
/// errors and sampling errors. Moments, mass and energy residual of a simulation are judged in
/// standard errors.
Quantities solution_quantities(const transform::Solution& solution, const Tolerances& tolerances);

/// Adds the metrics of a solver, judged by their kind. Words must be equal. Results and
/// coefficients are judged relative to their size, or to their least scale where that is larger. A
/// result with a standard error is judged in units of it, and the standard error itself by its
/// ratio, except that of a delicate value. Metrics of kind work and text are ignored.
/// @param whole the part of the whole solution. Quantities of kind `simulated_error` hold, in place
///        of their tolerance, the power of a standard error that they are proportional to
void add_metrics(const transform::Metrics& metrics, const Tolerances& tolerances,
                 const PartQuantities& whole);

/// Gives the metrics of a run read from files, which store values alone, the kinds and scales of
/// the same metrics in the new run.
transform::Metrics copy_metric_kinds(transform::Metrics baseline, const transform::Metrics& now);

/// l1, l2, sup, hellinger, kl and the decades of the tail of every pair of solutions. Of a pair
/// with a simulation only l1 is judged: by the triangle inequality l1 changes by no more than the
/// L1 distance between the two simulations. A kl that is infinite in one of the runs is left out: a
/// rounding error in the far tail decides between finite and infinite.
/// @param other the same case in the other run
Quantities distance_quantities(const results::Case& one, const results::Case& other,
                               const Tolerances& tolerances);

/// The error budget of every closure. Where its chain of models ends in a simulation that differs
/// by sampling, the parts that depend on the simulation are judged by its sampling error.
Quantities budget_quantities(const results::Case& one, const results::Case& other,
                             const Tolerances& tolerances);

/// Compares every marginal density and returns its bin with the largest change. For a simulation
/// the change is in standard errors, over the bins with a 95 % half-width of at most half the
/// density; the tolerance allows for their number. The L1 distance of the two simulations follows.
std::vector<QuantityChange> marginal_changes(const results::Case& baseline,
                                             const results::Case& now,
                                             const Tolerances& tolerances);

}  // namespace fpkcheck::check
