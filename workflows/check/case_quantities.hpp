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
/// in the two compared runs. Changes of results and coefficients are divided by the value, or by
/// the minimum scale of the metric if this scale is larger. The change of a result with a standard
/// error is in standard errors. The change of a standard error is its ratio between the two runs
/// minus 1. Standard errors of rounding-sensitive values, and metrics of kind work or text, are
/// ignored.
/// @param whole part that represents the whole solution. For a quantity of kind `simulated_error`,
/// the member `allowed` becomes the exponent of the standard error to which the quantity is
/// proportional.
void add_metric_quantities(const transform::Metrics& metrics, const Tolerances& tolerances,
                           const PartQuantityAppender& whole);

/// Copies the kinds and scales of metrics from the new run to the baseline, since files store only
/// the values of metrics.
transform::Metrics copy_metric_kinds(transform::Metrics baseline, const transform::Metrics& now);

/// Returns the distances l1, l2, sup, hellinger and kl and the distances in the decades of the
/// tail, for every pair of solutions. For a pair with a simulation, only the L1 distance is
/// returned. By the triangle inequality this distance changes by at most the L1 distance between
/// the simulations of the two runs. A Kullback-Leibler divergence `kl` that is infinite in one of
/// the runs is omitted, since rounding errors in the far tail decide whether it is finite.
/// @param case_in_other_run result of the same case in the other of the two compared runs
Quantities distance_quantities(const results::CaseResult& case_result,
                               const results::CaseResult& case_in_other_run,
                               const Tolerances& tolerances);

/// Returns the parts of the error budget of every closure. If the simulations of the two runs
/// differ by sampling, the tolerances of distances from the simulation follow from the sampling
/// error.
Quantities budget_quantities(const results::CaseResult& case_result,
                             const results::CaseResult& case_in_other_run,
                             const Tolerances& tolerances);

/// Returns the bin with the largest change of each marginal density. Changes of a simulated density
/// are in standard errors. Only bins of a simulated density whose 95 % interval has a half-width of
/// at most half the density are compared. The tolerance accounts for the number of compared bins.
/// For a simulation, the L1 distance between the two runs is an additional quantity.
std::vector<QuantityChange> marginal_changes(const results::CaseResult& baseline,
                                             const results::CaseResult& now,
                                             const Tolerances& tolerances);

}  // namespace fpkcheck::check
