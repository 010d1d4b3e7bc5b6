#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/families.hpp"
#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// How well the reference itself is known: how far others of the same problem are from it, and its
/// own account.
struct Level {
  std::string name;
  double l1;
  const char* dash;  ///< of plotly.js: "dot", "dash"
};

/// L1 distances of one variable to the reference of a case over the orders of families. Points into
/// the case; has what is away from the reference.
struct Convergence {
  const results::Case* one;
  const transform::Solution* reference;
  transform::Variable variable;
  std::vector<Family> families;                    ///< members by order
  std::vector<const transform::Solution*> guests;  ///< brought along, in none of these families
  std::vector<Level> levels;

  double l1(const transform::Solution& solution) const;
  /// The lowest and the highest order.
  std::pair<int, int> orders() const;
};

/// Nothing where there is no reference, or no family has two orders.
std::optional<Convergence> convergence(const results::Case& one, transform::Variable variable);

}  // namespace fpkcheck::report
