#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/axes.hpp"
#include "compare/budget.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// What the id of a solution ends with in a chain where its grids' limit is meant.
inline constexpr std::string_view kLimitOfGrids = " limit";

/// A model on the way from a closure to the truth, with its marginal of one variable.
struct ChainNode {
  std::string id;           ///< of a solution, or "fd-kf limit"
  std::vector<Link> links;  ///< what the step from the node before shows; empty for the closure
  transform::Marginal marginal;
  /// L1 distance to the limit of its own grids: 0 where there is no grid, absent where it is not
  /// known.
  std::optional<double> discretisation_error;
  std::optional<transform::SamplingError> sampling = {};  ///< where chance has a part
  const transform::SmoothEstimate* smooth = nullptr;      ///< of the smooth measure
};

/// The models between a closure and the truth, each of which differs from the one before in one
/// respect (its link):
///
///     closure -> closure's equation and impact, discretised            closure
///             -> the same equation, exact impact                       impact
///             -> full jump integral                                    truncation, white noise
///             -> what its grids tend to (Richardson)                   discretisation
///             -> simulation                                            sampling
///
/// Where a simulation knows itself in smooth bins (compare/smooth.hpp) all of the chain is in
/// these, and its last step, from the full jump integral to the simulation, is the discretisation
/// as measured. A model that is not there, not ok, or the same as the one before is left out; where it
/// is missing, the links join. The chain ends with the simulation, else the limit, else the full
/// equation itself.
/// @param closure one of the solutions
/// @return at least two nodes; none where there is no such end, or the closure has no marginal
std::vector<ChainNode> budget_chain(const ComparisonAxes& axes,
                                    std::span<const transform::Solution> solutions,
                                    std::span<const SolutionMarginal> marginals,
                                    const transform::Solution& closure,
                                    transform::Variable variable);

}  // namespace fpkcheck::compare
