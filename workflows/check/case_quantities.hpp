#pragma once

#include "results/run.hpp"
#include "workflows/check/quantity.hpp"
#include "workflows/check/tolerances.hpp"

/// Quantities of a case by which two runs are compared.
namespace fpkcheck::check {

constexpr const char* marginal_density_symbol(transform::StateVariable variable) {
  return variable == transform::StateVariable::ydot ? "p(y')" : "p(y)";
}

/// Returns the quantities of a solution. Changes of moments, mass and energy residual of a
/// simulation are measured in standard errors.
Quantities solution_quantities(const transform::Solution& solution, const Tolerances& tolerances);

/// Appends the metrics of a solver to the quantities of a solution. Words in metrics must be equal
/// in both runs. Changes of results and coefficients are relative to the value, or to the minimum
/// scale of the metric if this scale is larger. The change of a result with a standard error is in
/// standard errors. The change of a standard error is the ratio of both runs minus 1. Standard
/// errors of rounding-sensitive values, and metrics of kind work or text, are ignored.
/// @param whole part that represents the whole solution. For a quantity of kind `simulated_error`
///        the member `allowed` becomes an exponent: the quantity is proportional to this power of a
///        standard error
void add_metric_quantities(const transform::Metrics& metrics, const Tolerances& tolerances,
                           const PartQuantityAppender& whole);

/// Copies the kinds and scales of metrics from the new run, since files store only the values of
/// metrics.
transform::Metrics copy_metric_kinds(transform::Metrics baseline, const transform::Metrics& now);

/// Returns the distances l1, l2, sup, hellinger and kl and the distances in the decades of the
/// tail, for every pair of solutions. A pair with a simulation has only the distance l1. By the
/// triangle inequality the distance l1 changes by at most the L1 distance between the simulations
/// of both runs. A distance kl that is infinite in either run is omitted, since rounding errors in
/// the far tail decide whether kl is finite.
/// @param case_in_other_run result of the same case in the second run
Quantities distance_quantities(const results::CaseResult& case_result,
                               const results::CaseResult& case_in_other_run,
                               const Tolerances& tolerances);

/// Returns the parts of the error budget of every closure. If the simulations of both runs differ
/// by sampling, the tolerances of distances to the simulation follow from the sampling error.
Quantities budget_quantities(const results::CaseResult& case_result,
                             const results::CaseResult& case_in_other_run,
                             const Tolerances& tolerances);

/// Returns the bin with the largest change of each marginal density. Changes of a simulated density
/// are in standard errors. In a simulated density only bins whose 95 % interval has a half-width of
/// at most half the density are compared. The tolerance accounts for the number of compared bins.
/// For a simulation the L1 distance between both runs is a further quantity.
std::vector<QuantityChange> marginal_changes(const results::CaseResult& baseline,
                                             const results::CaseResult& now,
                                             const Tolerances& tolerances);

}  // namespace fpkcheck::check
