#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/families.hpp"
#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// A horizontal line of the convergence plot that shows the uncertainty of the reference: the L1
/// distance between the reference and another solution of the full problem, or the error estimate
/// of the reference.
struct UncertaintyLine {
  std::string name;
  double l1;
  const char* dash;  ///< dash type of gnuplot
};

/// L1 distances of one marginal density to the reference of a case, by family and order. The
/// members point to solutions of the case with a positive distance.
struct ConvergenceOverOrder {
  const results::CaseResult* case_result;
  const transform::Solution* reference;
  transform::Variable variable;
  std::vector<SolutionFamily> families;  ///< members sorted by order
  std::vector<const transform::Solution*>
      external_densities;  ///< external densities in no such family
  std::vector<UncertaintyLine> uncertainty_lines;

  double l1(const transform::Solution& solution) const;
  /// The lowest and the highest order n of the closures.
  std::pair<int, int> order_range() const;
};

/// The distances of one marginal density by family and order.
/// @return nothing if the case has no reference, or no family with at least two orders
std::optional<ConvergenceOverOrder> convergence_over_order(const results::CaseResult& case_result,
                                                           transform::Variable variable);

}  // namespace fpkcheck::report
