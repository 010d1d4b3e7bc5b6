#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns sentences on the error of each approximation in a case, computed from distances between
/// `ok` solutions:
///
/// - findings on the guaranteed bounds;
/// - the reference (compare/solution_assessment.hpp), if the case has several solutions;
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
std::vector<std::string> case_finding_sentences(const results::CaseResult& case_result);

/// Returns sentences on the guaranteed bounds of the moments of a case. The list of sentences is
/// empty if the computation of bounds was omitted; without bounds, a sentence states the reason.
/// The first sentences state each solution of the full problem with a moment that is outside the
/// guaranteed bounds by more than its error estimate. The last sentence states the bounds of E[y^2]
/// and E[y'^2], and the approximations with a moment outside its bounds.
std::vector<std::string> guaranteed_bounds_findings(const results::CaseResult& case_result);

/// Returns a text table of the guaranteed bounds. Each row of the table has the lower bound, upper
/// bound, and absolute and relative half-width for one functional.
std::string guaranteed_bounds_table(const problem::Problem& problem,
                                    const compare::GuaranteedBounds& bounds,
                                    const TerminalTextFormat& format);

}  // namespace fpkcheck::report
