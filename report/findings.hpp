#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Plain sentences that say which approximation costs what in one case, from the distances of the
/// solutions that are there and ok:
///
///   - what the guaranteed bounds say (report/bounds.hpp), where there are any;
///   - which solution is the reference (compare/reference.hpp), where there are several solutions;
///   - the discretisation error of an equation that states its own, or the largest of several; not
///     where there is an error budget, which has them;
///   - each approximate equation or impact, against the solution by the same method that differs in
///     that alone;
///   - the closure of each family and formulation that is closest to the reference, of those within
///     kCloseL1; several that its own error does not tell apart are called indistinguishable;
///   - the other solutions of the problem itself against the reference, beside what chance does;
///   - solutions from files against all these, beside what their standard errors explain;
///   - what solvers note for people: the observations `notes[k]`, or `X.notes[k]` of the file that
///     `X.file` names.
std::vector<std::string> findings(const results::Case& one);

}  // namespace fpkcheck::report
