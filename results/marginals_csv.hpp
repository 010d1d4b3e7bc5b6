#pragma once

#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Writes the marginal densities of all cases as CSV with the header
/// `case,solution,variable,abscissa,density,lower,upper`. Each row contains one bin of a marginal
/// density. All numbers are written with enough digits to be read back exactly.
/// @param curves member with the marginal densities: &CaseResult::curves, or &CaseResult::smooth
/// for smooth bins
void write_marginals_csv(std::ostream& out, std::span<const CaseResult> cases,
                         std::vector<DensityCurve> CaseResult::*curves = &CaseResult::curves);

struct CaseDensityCurve {
  std::string case_name;
  DensityCurve curve;
};

/// Function that returns whether the density of a solution of a case may be infinite or NaN.
using NonFinitePredicate =
    std::function<bool(const std::string& case_name, const std::string& solution)>;

/// Reads the marginal densities in a file that write_marginals_csv() wrote.
/// @param source name of the file, for messages
/// @param allows_non_finite selects solutions whose densities and confidence intervals may be
///   infinite or NaN. If the predicate `allows_non_finite` is empty, all numbers of the file must
///   be finite.
/// @throws InputError with a message of one line that states the source and the line number
std::vector<CaseDensityCurve> read_marginals_csv(std::istream& in, std::string_view source,
                                                 const NonFinitePredicate& allows_non_finite = {});

/// Encloses a text in quotes if the text contains separators, quotes or line breaks (RFC 4180).
std::string quote_csv_field(const std::string& text);

}  // namespace fpkcheck::results
