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

/// Writes one row for each bin of every curve of every case, under the header
/// `case,solution,variable,abscissa,density,lower,upper`. The number of digits suffices to read the
/// same numbers back.
/// @param curves &Case::curves, or &Case::smooth for curves over smooth bins
void write_marginals_csv(std::ostream& out, std::span<const Case> cases,
                         std::vector<Curve> Case::*curves = &Case::curves);

/// A curve with the name of its case.
struct CaseCurve {
  std::string case_name;
  Curve curve;
};

/// Whether the density of a solution of a case may be infinite or NaN.
using NonFinitePredicate =
    std::function<bool(const std::string& case_name, const std::string& solution)>;

/// Reads a file of write_marginals_csv. Numbers must be finite, except densities and intervals of
/// solutions that failed.
/// @param source the stream's name in messages
/// @param allows_non_finite selects these solutions; if empty, all numbers must be finite
/// @throws InputError on one line: source, line number and problem
std::vector<CaseCurve> read_marginals_csv(std::istream& in, std::string_view source,
                                          const NonFinitePredicate& allows_non_finite = {});

}  // namespace fpkcheck::results
