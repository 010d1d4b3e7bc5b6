#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns sentences on the error of each approximation in a case, computed from distances between
/// `ok` solutions:
///
/// - findings on the guaranteed bounds (report/guaranteed_bounds.hpp);
/// - the reference (compare/assessment.hpp), if the case has several solutions;
/// - the largest estimated discretisation error of the equations, unless the case has an error
///   budget;
/// - the L1 error of each approximate equation or impact condition: the distance from the solution
///   by the same method without this approximation;
/// - for each family and formulation, the closest closure to the reference, if its distance is at
///   most compare::kCloseL1, and all closures that are indistinguishable from this closure;
/// - the distances of the other solutions of the full problem from the reference, with sampling
///   errors;
/// - the distances of external densities from the solutions of the full problem, with standard
///   errors;
/// - notes of the solvers (metrics `notes[k]`), or notes on a file (metrics `X.notes[k]` and the
///   file name `X.file`).
std::vector<std::string> finding_sentences(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
