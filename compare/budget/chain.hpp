#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/case_report.hpp"

namespace fpkcheck::compare {

/// A model on the way from a closure to the truth, with its marginal of one variable.
struct ChainNode {
  std::string id;    ///< of a solution, or "fd-kf limit"
  std::string link;  ///< what the step from the node before shows; empty for the closure
  transform::Marginal marginal;
  /// L1 distance to the limit of its own grids: 0 where there is no grid, absent where it is not
  /// known.
  std::optional<double> discretisation_error;
};

/// The models between a closure and the truth, each of which differs from the one before in one
/// respect ("link"):
///
///     closure -> closure's equation and impact by finite differences   "closure"
///             -> the same equation, exact impact                       "impact"
///             -> full jump integral                                    "truncation", "white noise"
///             -> what its grids tend to (Richardson)                   "discretisation"
///             -> simulation                                            "sampling"
///
/// A model that is not there, not ok, or the same as the one before is left out; where it is
/// missing, the names of the links join ("closure + impact"). The truth is the simulation, else the
/// limit, else fd-kf.
/// @param closure an entry of the report with a marginal of this variable
/// @return at least two nodes; none where there is no truth to go to
std::vector<ChainNode> budget_chain(const CaseReport& report, const Entry& closure,
                                    transform::Variable variable);

}  // namespace fpkcheck::compare
