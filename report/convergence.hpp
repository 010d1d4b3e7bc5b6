#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/families.hpp"
#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// A horizontal line of the convergence plot that shows the uncertainty of the reference: the
/// distance of another solution of the full problem, or the error estimate of the reference.
struct UncertaintyLine {
  std::string name;
  double l1;
  const char* dash;  ///< dash style of plotly.js: "dot" or "dash"
};

/// L1 distances of a marginal density to the reference of a case, by family and order. Holds only
/// solutions with a positive distance, as pointers into the case.
struct Convergence {
  const results::Case* case_result;
  const transform::Solution* reference;
  transform::Variable variable;
  std::vector<Family> families;  ///< members sorted by order
  std::vector<const transform::Solution*>
      external_densities;  ///< external densities in no such family
  std::vector<UncertaintyLine> uncertainty_lines;

  double l1(const transform::Solution& solution) const;
  /// The lowest and the highest order.
  std::pair<int, int> orders() const;
};

/// @return nothing without a reference or without a family of at least two orders
std::optional<Convergence> convergence(const results::Case& case_result,
                                       transform::Variable variable);

}  // namespace fpkcheck::report
