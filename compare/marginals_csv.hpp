#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/case_report.hpp"

namespace fpkcheck::compare {

/// One curve of marginals.csv: a marginal density of one solution of one case.
struct MarginalCurve {
  std::string case_name;
  std::string solution;
  std::string variable;          ///< "y" or "ydot"
  std::vector<double> abscissa;  ///< n bin centres
  std::vector<double> density;   ///< n bin averages
  std::vector<double> lower;     ///< n lower ends of 95 % intervals, or empty
  std::vector<double> upper;     ///< n upper ends, or empty

  bool operator==(const MarginalCurve&) const = default;
};

/// The curves of a run, in the order of its cases, variables and solutions.
std::vector<MarginalCurve> marginal_curves(std::span<const CaseReport> cases);

/// One row per bin under the header `case,solution,variable,abscissa,density,lower,upper`, with as
/// many digits as it takes to read the same numbers back.
void write_marginals_csv(std::ostream& out, std::span<const MarginalCurve> curves);

/// Reads what write_marginals_csv wrote.
/// @param source how messages name the stream
/// @throws InputError on one line: source, line number and what is wrong
std::vector<MarginalCurve> read_marginals_csv(std::istream& in, std::string_view source);

}  // namespace fpkcheck::compare
