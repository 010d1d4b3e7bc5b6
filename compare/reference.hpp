#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// Selection of the reference solution of a case: the solution from which the distances of all
/// other solutions are reported.
namespace fpkcheck::compare {

/// L1 error estimate of a marginal density: the error estimate of the method; without an error
/// estimate, the expected sampling error; without both, infinity.
double l1_error_estimate(const transform::Solution& solution, transform::Variable variable);
/// Sum of the L1 error estimates of both marginal densities.
double l1_error_estimate(const transform::Solution& solution);

/// Whether a solution has a density, the status ok, and solves the full problem: a density equation
/// or a simulation with the jump integral (`kf`) and the exact impact condition.
bool is_solution_of_full_problem(const transform::Solution& solution);

/// Selects the reference of a case: the solution of the full problem with the smallest L1 error
/// estimate, summed over both marginals. Among solutions with equal or missing error estimates, the
/// most trusted solution is selected. Tables, plots, the page and sentences report distances from
/// the reference.
/// @param solutions by increasing trust
/// @return null if no solution satisfies is_solution_of_full_problem()
const transform::Solution* select_reference(std::span<const transform::Solution> solutions);

/// A sentence for reports on the id of the reference and the reason for its selection.
std::string reference_text(std::span<const transform::Solution> solutions);

/// L1 distances of a solution from the reference.
struct ReferenceDistance {
  const transform::Solution* solution;
  double y, ydot;  ///< distances in p(y) and in p(y')

  double l1_sum() const { return y + ydot; }
};

/// The distances of closures from the reference, by increasing sum of both distances. Closures
/// without status ok, and closures without a distance in either variable, are omitted.
std::vector<ReferenceDistance> closures_by_reference_distance(
    std::span<const transform::Solution> solutions, std::span<const PairDistances> pairs);

/// Whether the sums of the distances of two solutions differ by no more than the error estimate of
/// the reference. With so small a difference, neither solution counts as closer to the reference.
bool are_indistinguishable(const ReferenceDistance& first, const ReferenceDistance& second,
                           const transform::Solution& reference);

}  // namespace fpkcheck::compare
