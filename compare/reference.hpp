#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// The one rule for what is measured against what.
namespace fpkcheck::compare {

/// By how much a marginal may be off in L1, by the method's own account: the error that it states,
/// or what chance is expected to do; infinite where it says nothing.
double own_error(const transform::Solution& solution, transform::Variable variable);
/// Of both marginals together.
double own_error(const transform::Solution& solution);

/// True for a solution of the problem itself: ok, of the jumps (`kf`) and the exact impact, and not
/// of an assumed form.
bool solves_the_problem(const transform::Solution& solution);

/// The reference of a case: of the solutions of the problem itself the one that is known best by
/// its own account (own_error of both marginals); among equals, or where none says anything, the
/// more trusted, which is the later one. Everything is measured against it: tables, pictures,
/// the page and sentences.
/// @param solutions by increasing trust
/// @return null when there is none
const transform::Solution* reference(std::span<const transform::Solution> solutions);

/// In words, for reports: the rule, and whom it chose.
std::string reference_text(std::span<const transform::Solution> solutions);

/// How far a solution is from the reference, in L1.
struct Rank {
  const transform::Solution* solution;
  double y, ydot;

  double sum() const { return y + ydot; }
};

/// The closures that are ok and have both distances, the closest first.
std::vector<Rank> closures_by_distance(std::span<const transform::Solution> solutions,
                                       std::span<const PairDistances> pairs);

/// True where two ranks differ by no more than the reference's own error: then neither is called
/// the closer one.
bool indistinguishable(const Rank& one, const Rank& other, const transform::Solution& reference);

}  // namespace fpkcheck::compare
