#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Sentences that quantify the error of each approximation in one case, from the distances between
/// solutions with status ok:
///
///   - findings on the guaranteed bounds (report/bounds.hpp);
///   - the reference (compare/reference.hpp), if the case has several solutions;
///   - the discretisation error of an equation with an error estimate, or the largest of several;
///     omitted if the case has an error budget, which contains these errors;
///   - the L1 error of each approximate equation or impact: the distance to the solution by the
///     same method without this approximation;
///   - for each family and formulation the closure closest to the reference, if within kCloseL1;
///     closures are indistinguishable if their distances differ by no more than the error estimate
///     of the reference;
///   - the distances of the other solutions of the full problem to the reference, with sampling
///     errors;
///   - the distances of external densities to all of these, with standard errors;
///   - notes of the solvers: metrics `notes[k]`, or `X.notes[k]` of the file named by `X.file`.
std::vector<std::string> findings(const results::Case& one);

}  // namespace fpkcheck::report
