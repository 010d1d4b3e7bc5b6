#include "results/joint_density.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "made_up_solutions.hpp"

namespace fpkcheck::results {
namespace {

using transform::Variable;

const compare::ComparisonAxes kAxes = compare::comparison_axes(tests::paper_case(1));

// The eight synthetic solutions; the simulation's histogram is too rough for interpolation.
std::vector<transform::Solution> solutions_with_histogram() {
  auto solutions = tests::made_up_solutions(kAxes);
  transform::GridDensity histogram{kAxes.y_edges, kAxes.v_edges, {}};
  for (std::size_t k = 0; k < 140 * 140; ++k) {
    histogram.averages.push_back(static_cast<double>(k * 7919 % 5));
  }
  solutions.back().density = histogram;
  return solutions;
}

TEST(JointDensities, HaveTheOrderOfTheSolutions) {
  const auto found = [](const std::vector<transform::Solution>& solutions) {
    std::string ids;
    for (const auto& joint : joint_densities(kAxes, solutions)) ids += joint.solution + ' ';
    return ids;
  };
  const std::string all = "epc-gaussian-n2 epc-gaussian-n4 epc-gaussian-n6 fd-white fd-km4 fd-kf ";
  EXPECT_EQ(found(tests::made_up_solutions(kAxes)), all);
  EXPECT_EQ(found(solutions_with_histogram()), all + "mcs ");
}

TEST(JointDensities, HaveMassOneAndTheMarginalsOfTheRun) {
  const auto one = tests::made_up_case();
  constexpr double kSinglePrecision = 6e-8;
  for (const auto& [solution, density] : one.joints) {
    ASSERT_EQ(density.ny(), 70u);
    ASSERT_EQ(density.nv(), 140u);
    EXPECT_NEAR(mass(density), 1, 1e-6) << solution;
    for (const auto variable : transform::kVariables) {
      const auto& bins = variable == Variable::y ? density.y_edges : density.v_edges;
      const auto own = transform::marginal(density, variable, bins);
      const auto& p = one.curve(solution, variable)->density;
      for (std::size_t b = 0; b < own.size(); ++b) {
        const double expected = variable == Variable::y ? (p[2 * b] + p[2 * b + 1]) / 2 : p[b];
        EXPECT_NEAR(own.density[b], expected, kSinglePrecision) << solution << " bin " << b;
      }
    }
  }
}

TEST(JointDensities, OfASimulationSumItsCells) {
  const auto solutions = solutions_with_histogram();
  const auto joint = joint_densities(kAxes, solutions).back();
  ASSERT_EQ(joint.solution, "mcs");
  const auto& histogram = std::get<transform::GridDensity>(*solutions.back().density);
  for (const auto& [i, j] : {std::pair{0, 0}, {3, 69}, {3, 70}, {69, 139}}) {
    EXPECT_NEAR(joint.density.cell_average(i, j),
                (histogram.cell_average(2 * i, j) + histogram.cell_average(2 * i + 1, j)) / 2, 1e-6)
        << i << " " << j;
  }
}

}  // namespace
}  // namespace fpkcheck::results
