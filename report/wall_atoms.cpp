#include "report/wall_atoms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace fpkcheck::report {

std::vector<double> walls_with_rest_atoms(const results::CaseResult& case_result) {
  std::set<double> walls;
  for (const auto& solution : case_result.solutions) {
    for (const auto& atom : solution.atoms) walls.insert(atom.y);
  }
  return {walls.begin(), walls.end()};
}

std::string rest_probability_header(const results::CaseResult& case_result, double wall) {
  return walls_with_rest_atoms(case_result).size() == 1 ? std::string("P(rest)")
                                                        : fmt::format("P(rest at {:g})", wall);
}

double rest_atom_probability(const transform::Solution& solution, double wall) {
  const auto found = std::ranges::find(solution.atoms, wall, &transform::RestAtom::y);
  return found == solution.atoms.end() ? std::numeric_limits<double>::quiet_NaN()
                                       : found->probability;
}

}  // namespace fpkcheck::report
