#include "compare/rest_atoms.hpp"

#include <gtest/gtest.h>

#include "compare/comparison.hpp"

namespace fpkcheck::compare {
namespace {

using transform::RestAtom;
using transform::StateVariable;

TEST(RestAtoms, OfDifferentWallsDifferInYOnly) {
  const std::vector<RestAtom> left{{-0.5, 0.3}}, right{{0.5, 0.2}}, both{{-0.5, 0.1}, {0.5, 0.2}};
  EXPECT_DOUBLE_EQ(rest_atom_l1_distance(left, right, StateVariable::y), 0.5);
  EXPECT_DOUBLE_EQ(rest_atom_l1_distance(left, right, StateVariable::ydot), 0.1);
  EXPECT_DOUBLE_EQ(rest_atom_l1_distance(left, both, StateVariable::y), 0.4);
  EXPECT_NEAR(rest_atom_l1_distance(left, both, StateVariable::ydot), 0, 1e-16);
  EXPECT_DOUBLE_EQ(rest_atom_l1_distance({}, left, StateVariable::y), 0.3);
  EXPECT_EQ(rest_atom_l1_distance({}, {}, StateVariable::y), 0);
}

// Equal densities of mass 1/2: only the atoms differ.
TEST(RestAtoms, ContributeToTheDistanceOfSolutions) {
  const ComparisonBins axes{{0, 1, 2}, {-1, 0, 1}, 0};
  const auto solution = [](const char* id, double p0) {
    transform::Solution s;
    s.identity.id = id;
    s.status = transform::Status::ok;
    s.density = transform::GridDensity{{0, 1, 2}, {-1, 0, 1}, {0.125, 0.125, 0.125, 0.125}};
    s.atoms = {{0, p0}};
    return s;
  };
  const transform::Solution both[] = {solution("one", 0.5), solution("other", 0.4)};
  const auto compared = compare_solutions(axes, both);
  for (const auto variable : transform::kVariables) {
    EXPECT_NEAR(*l1_distance_between(compared.pairs, "one", "other", variable), 0.1, 1e-15);
  }
}

}  // namespace
}  // namespace fpkcheck::compare
