#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// Selection of the reference solution, with which all solutions are compared.
namespace fpkcheck::compare {

/// Error estimate of a marginal in L1: the error estimate of the method, else the expected sampling
/// error, else infinity.
double error_estimate(const transform::Solution& solution, transform::Variable variable);
/// Sum of the error estimates of both marginals.
double error_estimate(const transform::Solution& solution);

/// True for a solution of the full problem: status ok, a density equation or a simulation with the
/// jumps themselves (`kf`) and the exact impact.
bool is_solution_of_full_problem(const transform::Solution& solution);

/// The reference of a case: the solution of the full problem with the smallest error estimate,
/// summed over both marginals. Among equal or missing error estimates the later, more trusted
/// solution is selected. Tables, plots, the page and sentences measure distances from it.
/// @param solutions by increasing trust
/// @return null if no solution qualifies
const transform::Solution* reference(std::span<const transform::Solution> solutions);

/// A sentence for reports: the reference and the reason for its selection.
std::string reference_text(std::span<const transform::Solution> solutions);

/// L1 distances of a solution from the reference.
struct ReferenceDistance {
  const transform::Solution* solution;
  double y, ydot;

  double sum() const { return y + ydot; }
};

/// The closures with status ok and both distances, by increasing distance.
std::vector<ReferenceDistance> closures_by_reference_distance(
    std::span<const transform::Solution> solutions, std::span<const PairDistances> pairs);

/// True if two distances differ by no more than the error estimate of the reference: then neither
/// solution counts as the closer.
bool is_indistinguishable(const ReferenceDistance& first, const ReferenceDistance& second,
                          const transform::Solution& reference);

}  // namespace fpkcheck::compare
