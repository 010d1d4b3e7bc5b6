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

/// One row per bin of every curve of every case, under the header
/// `case,solution,variable,abscissa,density,lower,upper`, with as many digits as it takes to read
/// the same numbers back.
/// @param curves which ones: &Case::curves, or &Case::smooth, whose bins are smooth ones
void write_marginals_csv(std::ostream& out, std::span<const Case> cases,
                         std::vector<Curve> Case::*curves = &Case::curves);

/// A curve with the name of its case.
struct CurveOfCase {
  std::string case_name;
  Curve curve;
};

/// Of which solution of which case a density may be infinite or no number.
using MayBreakDown = std::function<bool(const std::string& case_name, const std::string& solution)>;

/// Reads what write_marginals_csv wrote. Numbers must be finite but for densities and intervals
/// where a solution broke down.
/// @param source how messages name the stream
/// @param may_break_down if empty, none may
/// @throws InputError on one line: source, line number and what is wrong
std::vector<CurveOfCase> read_marginals_csv(std::istream& in, std::string_view source,
                                            const MayBreakDown& may_break_down = {});

}  // namespace fpkcheck::results
