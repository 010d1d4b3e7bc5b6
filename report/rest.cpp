#include "report/rest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace fpkcheck::report {

std::vector<double> walls_of_rest(const results::Case& one) {
  std::set<double> walls;
  for (const auto& solution : one.solutions) {
    for (const auto& atom : solution.atoms) walls.insert(atom.y);
  }
  return {walls.begin(), walls.end()};
}

std::string rest_header(const results::Case& one, double wall) {
  return walls_of_rest(one).size() == 1 ? std::string("P(rest)")
                                        : fmt::format("P(rest at {:g})", wall);
}

double probability_of_rest(const transform::Solution& solution, double wall) {
  const auto found = std::ranges::find(solution.atoms, wall, &transform::RestAtom::y);
  return found == solution.atoms.end() ? std::numeric_limits<double>::quiet_NaN()
                                       : found->probability;
}

}  // namespace fpkcheck::report
