#pragma once

#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Writes the marginal densities of all cases as CSV. The header is
/// `case,solution,variable,abscissa,density,lower,upper`; every bin of every curve is one row. The
/// numbers have sufficient digits to be read back without rounding errors.
/// @param curves the curves to write: &CaseResult::curves, or &CaseResult::smooth for curves over
///        smooth bins
void write_marginals_csv(std::ostream& out, std::span<const CaseResult> cases,
                         std::vector<Curve> CaseResult::*curves = &CaseResult::curves);

/// A curve with the name of its case.
struct CaseCurve {
  std::string case_name;
  Curve curve;
};

/// Function that returns whether the density of a solution of a case may be infinite or NaN.
using NonFinitePredicate =
    std::function<bool(const std::string& case_name, const std::string& solution)>;

/// Reads a file that write_marginals_csv() wrote. All numbers must be finite, except the densities
/// and confidence intervals of the solutions that `allows_non_finite` selects.
/// @param source name of the file, for messages
/// @param allows_non_finite function that selects solutions; if empty, all numbers must be finite
/// @throws InputError with a message of one line: source, line number and problem
std::vector<CaseCurve> read_marginals_csv(std::istream& in, std::string_view source,
                                          const NonFinitePredicate& allows_non_finite = {});

/// The field of a CSV file for a text. A text with separators, quotes or line breaks is quoted
/// (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace fpkcheck::results
