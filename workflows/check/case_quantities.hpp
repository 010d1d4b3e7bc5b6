#pragma once

#include "results/run.hpp"
#include "workflows/check/compared_quantity.hpp"
#include "workflows/check/tolerances.hpp"

/// Quantities of one case, numbers and words, that a check compares between two runs.
namespace fpkcheck::check {

constexpr const char* marginal_density_symbol(transform::StateVariable variable) {
  return variable == transform::StateVariable::ydot ? "p(y')" : "p(y)";
}

/// Returns the quantities of a solution that are compared between two runs. Changes of moments,
/// mass and energy residual of a simulation are measured in standard errors.
CheckedQuantities solution_quantities(const transform::Solution& solution,
                                      const BaselineCheckTolerances& tolerances);

/// Appends the metrics that a solver reports to the compared quantities of a solution. Metrics with
/// words as values must be equal in the two compared runs. The change of a deterministic metric is
/// divided by its value, or by the minimum scale of the metric if this scale is larger. The change
/// of a metric with a standard error is measured in standard errors. The change of a standard error
/// is the ratio of its values in the two compared runs, minus 1. Standard errors of
/// rounding-sensitive values, and metrics of kind `work` or `text`, are ignored.
/// @param whole part of the compared quantities that represents the whole solution. For a quantity
///        of kind `simulated_error`, the member `allowed` becomes the exponent of the standard
///        error to which the quantity is proportional.
void add_metric_quantities(const transform::Metrics& metrics,
                           const BaselineCheckTolerances& tolerances,
                           const SolutionPartQuantityAppender& whole);

/// Copies the kinds and scales of metrics from the new run to the baseline run, since files store
/// only the values of metrics.
transform::Metrics copy_metric_kinds_from_repeated_run(transform::Metrics baseline,
                                                       const transform::Metrics& now);

/// Returns the quantities l1, l2, sup, hellinger and kl and the distances in the decades of the
/// tail, for every pair of solutions. For a pair of solutions that includes a simulation, only the
/// L1 distance is returned. By the triangle inequality the L1 distance of a solution from a
/// simulation changes by at most the L1 distance between the simulations of the two compared runs.
/// A Kullback-Leibler divergence that is infinite in one of two runs is omitted, since rounding
/// errors in the far tail decide whether the divergence is finite.
/// @param case_in_other_run result of the same case in the other of the two compared runs
CheckedQuantities distance_quantities(const results::CaseResult& case_result,
                                      const results::CaseResult& case_in_other_run,
                                      const BaselineCheckTolerances& tolerances);

/// Returns the parts of the error budget of every closure as compared quantities. If the
/// simulations of two compared runs differ by sampling, the tolerances of distances from the
/// simulation follow from the sampling error.
CheckedQuantities budget_quantities(const results::CaseResult& case_result,
                                    const results::CaseResult& case_in_other_run,
                                    const BaselineCheckTolerances& tolerances);

/// Returns, for each marginal density, the bin with the largest change between two runs. Changes of
/// a simulated density are measured in standard errors. Bins of a simulated density are compared
/// only if the half-width of the 95 % confidence interval is at most half the density. The
/// tolerance of changes in bins accounts for the number of compared bins. For a simulation, the L1
/// distance between its densities in the two compared runs is an additional compared quantity.
std::vector<CheckedQuantityChange> marginal_changes(const results::CaseResult& baseline,
                                                    const results::CaseResult& now,
                                                    const BaselineCheckTolerances& tolerances);

}  // namespace fpkcheck::check
