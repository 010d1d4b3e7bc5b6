#pragma once

#include "results/run.hpp"
#include "workflows/check/quantity.hpp"
#include "workflows/check/tolerances.hpp"

/// The quantities of a case by which two runs are compared.
namespace fpkcheck::check {

/// The symbol of a marginal density: "p(y)" or "p(y')".
constexpr const char* density_name(transform::Variable variable) {
  return variable == transform::Variable::ydot ? "p(y')" : "p(y)";
}

/// The quantities of a solution: equation and impact condition, status, moments, mass, energy
/// residual, smallest density, error estimate, then the metrics. The quantities of a simulation
/// include the standard errors and the sampling errors. Changes of moments, mass and energy
/// residual of a simulation are judged in standard errors.
Quantities solution_quantities(const transform::Solution& solution, const Tolerances& tolerances);

/// Adds the metrics of a solver to the quantities. The kind of a metric determines how its change
/// is judged. Words must be equal. Changes of results and coefficients are relative to the value of
/// the metric, or to the least scale of the metric if this scale exceeds the value. The change of a
/// result with a standard error is in units of the standard error. The change of a standard error
/// is the ratio of both runs minus 1; the standard error of a rounding-sensitive value is ignored.
/// Metrics of kind work and text are ignored.
/// @param whole the part that represents the whole solution. The tolerance of a quantity of kind
///        `simulated_error` is replaced by an exponent: the quantity is proportional to this power
///        of a standard error
void add_metric_quantities(const transform::Metrics& metrics, const Tolerances& tolerances,
                           const PartQuantities& whole);

/// Copies kinds and scales from the metrics of the new run to the same metrics of a run that was
/// read from files, since files store only the values.
transform::Metrics copy_metric_kinds(transform::Metrics baseline, const transform::Metrics& now);

/// The distances l1, l2, sup, hellinger and kl and the distances in the decades of the tail, for
/// every pair of solutions. For a pair with a simulation only l1 is compared: by the triangle
/// inequality l1 changes by at most the L1 distance between the two simulations. A distance kl that
/// is infinite in one of the runs is omitted, since a rounding error in the far tail decides
/// whether kl is finite.
/// @param other the result of the same case in the second run
Quantities distance_quantities(const results::CaseResult& one, const results::CaseResult& other,
                               const Tolerances& tolerances);

/// The parts of the error budget of every closure. If the total distance refers to a simulation,
/// and the simulations of both runs differ by sampling, the tolerance of the parts that depend on
/// the simulation follows from the sampling error.
Quantities budget_quantities(const results::CaseResult& one, const results::CaseResult& other,
                             const Tolerances& tolerances);

/// Compares every marginal density, and returns the bin of the density with the largest change. For
/// a simulation the change is in standard errors. Only bins whose 95 % interval has a half-width of
/// at most half the density are compared, and the tolerance takes the number of these bins into
/// account. For a simulation the L1 distance between both simulations is a further quantity.
std::vector<QuantityChange> marginal_changes(const results::CaseResult& baseline,
                                             const results::CaseResult& now,
                                             const Tolerances& tolerances);

}  // namespace fpkcheck::check
