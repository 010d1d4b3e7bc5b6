#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Sentences that quantify the error of each approximation in one case by distances between
/// solutions with status ok:
///
///   - findings on the guaranteed bounds (report/guaranteed_bounds.hpp);
///   - the reference (compare/assessment.hpp), if the case has several solutions;
///   - the estimated discretisation error of an equation, or the largest estimate of several
///     equations; omitted if the case has an error budget, which contains the discretisation
///     errors;
///   - the L1 error of each approximate equation or impact condition: the L1 distance to the
///     solution by the same method without this approximation;
///   - for each family and formulation the closure closest to the reference, if its distance is at
///     most compare::kCloseL1; closures are indistinguishable if their distances differ by at most the error
///     estimate of the reference;
///   - the distances of the other solutions of the full problem to the reference, with sampling
///     errors;
///   - the distances of external densities to the reference and to the other solutions of the full
///     problem, with standard errors;
///   - notes of the solvers, from the metrics `notes[k]`; or notes on a file, from the metrics
///     `X.notes[k]` and the file name `X.file`.
std::vector<std::string> findings(const results::CaseResult& one);

}  // namespace fpkcheck::report
