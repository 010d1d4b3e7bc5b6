#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/axes.hpp"
#include "compare/distances.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// A solution with what only its method knows.
struct Entry {
  transform::Solution solution;
  nlohmann::ordered_json options;  ///< what the method was asked for
  nlohmann::ordered_json details;  ///< an object of the method's own summary fields
};

/// A marginal of one solution on the comparison axes.
struct SolutionMarginal {
  std::string solution;  ///< id
  transform::Variable variable;
  transform::Marginal marginal;
};

/// Distances between one marginal of two solutions; `b` is the reference.
struct Comparison {
  std::string a;
  std::string b;
  transform::Variable variable;
  Distances distances;
};

/// Everything a run found out about one case.
struct CaseReport {
  problem::Problem problem;
  ComparisonAxes axes;
  std::vector<Entry> entries;
  std::vector<SolutionMarginal> marginals;
  std::vector<Comparison> comparisons;
};

/// Marginals of all entries that have a density, and the distances of all their pairs in both
/// variables.
/// @param entries by increasing trust (epc, fd-white, fd-km4, fd-kf, mcs): of a pair, the later one
///                is the reference
CaseReport report_on_case(const problem::Problem& problem, const ComparisonAxes& axes,
                          std::vector<Entry> entries);

}  // namespace fpkcheck::compare
