#include "compare/joint_density.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Variable;

// The eight made-up solutions, and the simulation with a histogram that no polynomial could follow.
CaseReport report_with_histogram() {
  CaseReport report = tests::full_report();
  transform::GridDensity histogram{report.axes.y_edges, report.axes.v_edges, {}};
  for (std::size_t k = 0; k < 140 * 140; ++k) {
    histogram.averages.push_back(static_cast<double>(k * 7919 % 5));
  }
  report.entries.back().solution.density = histogram;
  return report;
}

TEST(JointDensities, AreOfAllSolutionsThatHaveOneInTheOrderOfTheCases) {
  const std::vector<CaseReport> cases{tests::full_report("a"), report_with_histogram()};
  std::vector<std::string> found;
  for (const auto& joint : joint_densities(cases)) {
    found.push_back(joint.case_name + " " + joint.solution);
  }
  EXPECT_EQ(found, (std::vector<std::string>{
                       "a epc-gaussian-n2", "a epc-gaussian-n4", "a epc-gaussian-n6", "a fd-white",
                       "a fd-km4", "a fd-kf", "case1 epc-gaussian-n2", "case1 epc-gaussian-n4",
                       "case1 epc-gaussian-n6", "case1 fd-white", "case1 fd-km4", "case1 fd-kf",
                       "case1 mcs"}));
}

TEST(JointDensities, HaveMassOneAndTheMarginalsOfTheRun) {
  const CaseReport report = tests::full_report();
  constexpr double kSinglePrecision = 6e-8;
  for (const auto& [case_name, solution, density] : joint_densities(std::span(&report, 1))) {
    ASSERT_EQ(density.ny(), 70u);
    ASSERT_EQ(density.nv(), 140u);
    EXPECT_NEAR(mass(density), 1, 1e-6) << solution;
    for (const auto& marginal : report.marginals) {
      if (marginal.solution != solution) continue;
      const auto& bins = marginal.variable == Variable::y ? density.y_edges : density.v_edges;
      const auto own = transform::marginal(density, marginal.variable, bins);
      for (std::size_t b = 0; b < own.size(); ++b) {
        const auto& p = marginal.marginal.density;
        const double expected =
            marginal.variable == Variable::y ? (p[2 * b] + p[2 * b + 1]) / 2 : p[b];
        EXPECT_NEAR(own.density[b], expected, kSinglePrecision) << solution << " bin " << b;
      }
    }
  }
}

TEST(JointDensities, OfASimulationAreSumsOfItsCells) {
  const CaseReport report = report_with_histogram();
  const auto joint = joint_densities(std::span(&report, 1)).back();
  ASSERT_EQ(joint.solution, "mcs");
  const auto& histogram = std::get<transform::GridDensity>(*report.entries.back().solution.density);
  for (const auto& [i, j] : {std::pair{0, 0}, {3, 69}, {3, 70}, {69, 139}}) {
    EXPECT_NEAR(joint.density.average(i, j),
                (histogram.average(2 * i, j) + histogram.average(2 * i + 1, j)) / 2, 1e-6)
        << i << " " << j;
  }
}

}  // namespace
}  // namespace fpkcheck::compare
