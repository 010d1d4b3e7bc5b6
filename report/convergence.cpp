#include "report/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/reference.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

int order_of(const Solution* solution) { return *solution->identity.order; }

std::vector<Level> levels(const Convergence& found) {
  std::vector<Level> all;
  for (const Solution* other : references(*found.one)) {
    const double l1 = found.l1(*other);
    if (l1 > 0)
      all.push_back(
          {fmt::format("distance of {} to {}", other->id(), found.reference->id()), l1, "dot"});
  }
  const double own = compare::own_error(*found.reference, found.variable);
  if (std::isfinite(own) && own > 0) {
    all.push_back({"error estimate of " + found.reference->id(), own, "dash"});
  }
  return all;
}

}  // namespace

double Convergence::l1(const Solution& solution) const {
  return one->l1(solution.id(), reference->id(), variable).value_or(0);
}

std::pair<int, int> Convergence::orders() const {
  int first = order_of(families.front().solutions.front()), last = first;
  const auto include = [&](const Solution* solution) {
    first = std::min(first, order_of(solution));
    last = std::max(last, order_of(solution));
  };
  for (const Family& family : families) std::ranges::for_each(family.solutions, include);
  for (const Solution* guest : guests) {
    if (guest->identity.order) include(guest);
  }
  return {first, last};
}

std::optional<Convergence> convergence(const results::Case& one, transform::Variable variable) {
  const Solution* reference = compare::reference(one.solutions);
  if (reference == nullptr) return std::nullopt;
  Convergence found{.one = &one,
                    .reference = reference,
                    .variable = variable,
                    .families = {},
                    .guests = {},
                    .levels = {}};
  std::vector<const Solution*> by_order;
  for (const auto& solution : one.solutions) {
    if (!(found.l1(solution) > 0)) continue;
    if (transform::is_by_order(solution.identity)) {
      by_order.push_back(&solution);
    } else if (transform::is_guest(solution.identity)) {
      found.guests.push_back(&solution);
    }
  }
  found.families = families(by_order);
  const bool any = std::ranges::any_of(
      found.families, [](const Family& family) { return family.solutions.size() > 1; });
  if (!any) return std::nullopt;
  for (Family& family : found.families) std::ranges::stable_sort(family.solutions, {}, order_of);
  found.levels = levels(found);
  return found;
}

}  // namespace fpkcheck::report
