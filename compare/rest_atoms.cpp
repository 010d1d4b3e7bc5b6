#include "compare/rest_atoms.hpp"

#include <cmath>
#include <map>

namespace fpkcheck::compare {

double rest_atom_l1_distance(const std::vector<transform::RestAtom>& a,
                             const std::vector<transform::RestAtom>& b,
                             transform::StateVariable variable) {
  std::map<double, double> difference;  // difference of the probabilities, by position of the atom
  const auto place = [&](const transform::RestAtom& atom) {
    return variable == transform::StateVariable::y ? atom.y : 0;
  };
  for (const auto& atom : a) difference[place(atom)] += atom.probability;
  for (const auto& atom : b) difference[place(atom)] -= atom.probability;
  double sum = 0;
  for (const auto& [at, probability] : difference) sum += std::abs(probability);
  return sum;
}

}  // namespace fpkcheck::compare
