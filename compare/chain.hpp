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

/// Suffix of a solution's id in a chain that denotes the Richardson limit of its grids.
inline constexpr std::string_view kGridLimitSuffix = " limit";

/// A model of the chain from a closure to the reference, with its marginal of one variable.
struct ChainNode {
  std::string id;           ///< id of a solution, or "fd-kf limit"
  std::vector<Link> links;  ///< differences from the previous node; empty for the closure
  transform::Marginal marginal;
  /// L1 distance to the limit of its grids: 0 if the node has no grid, empty if unknown.
  std::optional<double> discretisation_error;
  std::optional<transform::SamplingError> sampling = {};  ///< of a simulation
  const transform::SmoothEstimate* smooth = nullptr;      ///< of the smooth reference
};

/// The models between a closure and the reference. Each differs from the previous model in one
/// respect (its link):
///
///     closure -> the closure's equation and impact, discretised        closure
///             -> the same equation, exact impact                       impact
///             -> full jump integral                                    truncation, white noise
///             -> Richardson limit of its grids                         discretisation
///             -> simulation                                            sampling
///
/// If a simulation has smooth estimates (compare/smooth_reference.hpp), the whole chain uses smooth
/// bins. Its last step, from the full jump integral to the simulation, is then the measured
/// discretisation error. A model that is missing, not ok or equal to the previous model is omitted,
/// and the links of a missing model are joined. The chain ends with the simulation, else with the
/// limit, else with the full equation.
/// @param closure one of the solutions
/// @return at least two nodes; empty if the chain has no end or the closure has no marginal
std::vector<ChainNode> model_chain(const ComparisonAxes& axes,
                                   std::span<const transform::Solution> solutions,
                                   std::span<const SolutionMarginal> marginals,
                                   const transform::Solution& closure,
                                   transform::Variable variable);

}  // namespace fpkcheck::compare
