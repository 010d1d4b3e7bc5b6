#pragma once

#include <stdexcept>
#include <string>

#include "made_up_solutions.hpp"

/// Modifications of the synthetic case, and a helper for wrapped text.
namespace fpkcheck::tests {

inline transform::Solution& solution_of(results::CaseResult& case_result, const std::string& id) {
  for (auto& solution : case_result.solutions) {
    if (solution.id() == id) return solution;
  }
  throw std::logic_error("no " + id);
}

/// Sets the L1 distances of a pair, and assesses the case again.
inline void set_l1(results::CaseResult& case_result, const std::string& a, const std::string& b,
                   double y, double ydot) {
  for (auto& pair : case_result.pairs) {
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) {
      pair.distances.l1 = pair.variable == transform::StateVariable::y ? y : ydot;
    }
  }
  case_result.update_assessment();
}

/// The case with only its first `count` solutions and their comparisons.
inline results::CaseResult case_with_first(std::size_t count) {
  auto problem = paper_case(1);
  const auto axes = compare::comparison_bins(problem);
  auto solutions = made_up_solutions(axes);
  solutions.resize(count);
  return results::make_case_result(problem, axes, std::move(solutions));
}

/// Replaces each sequence of blanks and line ends by a single blank, since wrapped lines may break
/// anywhere.
inline std::string collapse_whitespace(const std::string& text) {
  std::string joined;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank) {
      joined += c;
    } else if (!joined.ends_with(' ')) {
      joined += ' ';
    }
  }
  return joined;
}

}  // namespace fpkcheck::tests
