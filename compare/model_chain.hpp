#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// Suffix in the id of the Richardson limit of a finite-volume solution: "fd-kf limit".
inline constexpr std::string_view kGridLimitSuffix = " limit";

/// One of the increasingly exact models from a closure to the reference, in one variable.
struct ModelInApproximationChain {
  std::string id;  ///< id of a solution, or "fd-kf limit"
  /// Approximations that the previous model makes and this model avoids; empty for the closure.
  std::vector<ModelApproximation> approximations;
  transform::Marginal marginal;
  /// L1 distance of the density of a model from the Richardson limit of its grids. The distance
  /// from the Richardson limit is 0 for a model without a grid, and empty if the limit is unknown.
  std::optional<double> discretisation_error;
  std::optional<transform::MarginalSamplingErrors> sampling =
      {};  ///< sampling error of a simulation
  /// Estimates over smooth bins, if the model is the simulation that serves as smooth reference;
  /// null for other models.
  const transform::SmoothBinEstimate* smooth = nullptr;
};

/// Returns the chain of increasingly exact models from a closure to the reference. Each model
/// avoids one approximation (right column) of the previous model:
///
///     closure -> the closure's equation and impact, discretised        closure
///             -> the same equation, exact impact                       impact
///             -> full jump integral                                    truncation, white noise
///             -> Richardson limit of its grids                         discretisation
///             -> simulation                                            sampling
///
/// If a simulation has smooth estimates (compare/smooth_reference.hpp), all marginal densities of
/// the chain are over smooth bins. The distance over smooth bins from the finite-volume solution of
/// the full jump integral to the simulation is then the measured discretisation error. The chain of
/// models omits a model that is missing, not `ok` or equal to the previous model. If a model is
/// omitted from the chain, the next model takes over its approximations. The last model of the
/// chain is the simulation, or else the Richardson limit, or else the finite-volume solution for
/// the full jump integral.
/// @param closure one of the solutions
/// @return at least two models; an empty list if the closure has no marginal density, or if no
/// solution of the full jump integral exists
std::vector<ModelInApproximationChain> make_model_chain(
    const ComparisonBins& axes, std::span<const transform::Solution> solutions,
    std::span<const SolutionMarginalDensity> marginals, const transform::Solution& closure,
    transform::StateVariable variable);

}  // namespace fpkcheck::compare
