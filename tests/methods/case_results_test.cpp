#include "methods/case_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::methods {
namespace {

constexpr double kTrueY2 = 0.3945181772, kTrueV2 = 0.4415122125;  // case 1, accurate to 7e-10

double integral(const transform::GridDensity& map) {
  double sum = 0;
  for (std::size_t i = 0; i < map.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < map.v_cell_count(); ++j) {
      sum += map.cell_average(i, j) * (map.y_edges[i + 1] - map.y_edges[i]) *
             (map.v_edges[j + 1] - map.v_edges[j]);
    }
  }
  return sum;
}

TEST(MomentErrorEstimates, CorrectTheMomentsOfEverySolution) {
  auto cases = run_cases(
      {tests::paper_case(1)},
      builtin_registry().methods_selected_by_list(
          "epc-gaussian-n2,epc-gaussian-n6,epc-moment-n8,fd-white,fd-kf,mcs", {{"time", 2e4}}),
      0, {});
  add_moment_error_estimates(cases.front(), ResidualErrorEstimator(tests::paper_case(1)), 0);
  const auto& one = cases.front();
  ASSERT_EQ(one.moment_error_estimates.size(), 5u);  // all solutions but the histogram
  ASSERT_EQ(one.error_sources.size(), 10u);
  for (const auto& own : one.moment_error_estimates) {
    SCOPED_TRACE(own.solution);
    const auto& moments = one.find(own.solution)->moments;
    EXPECT_NEAR(own.corrected.y2, kTrueY2, 3e-9);
    EXPECT_NEAR(own.corrected.v2, kTrueV2, 3e-9);
    EXPECT_NEAR(own.error.y2, moments.y2 - kTrueY2, 3e-9);
    EXPECT_NEAR(own.error.v2, moments.v2 - kTrueV2, 3e-9);
    EXPECT_NEAR(own.corrected.v1, 0, 1e-9);
    for (const auto& source : one.error_sources) {
      if (source.solution != own.solution) continue;
      const double error = source.moment == "y2" ? own.error.y2 : own.error.v2;
      // The solver's moments and those of its density differ by quadrature errors. Contributions
      // from beyond the cells are missing.
      EXPECT_NEAR(integral(source.density), error, 5e-6 + 2e-3 * std::abs(error));
    }
  }
}

TEST(MomentErrorEstimates, HavePhysicalAxesForMirroredProblems) {
  const problem::System system({.damping = 0.2, .stiffness = 1},
                               {.right = 0.5, .right_restitution = 1});
  const auto known = tests::with_noise(system, 0.4), weaker = tests::with_noise(system, 0.36);
  const exact::EnergyLaw law(weaker), truth(known);
  results::CaseResult one{
      .problem = known, .solutions = {}, .pairs = {}, .budget = {}, .curves = {}, .joints = {}};
  transform::Solution solution;
  solution.identity.id = "one";
  solution.identity.role = transform::SolutionRole::closure;
  solution.density = transform::SmoothDensity{law, 0.5, 6, -6};
  solution.moments = {law.moment(1, 0), law.moment(2, 0), law.moment(4, 0),
                      law.moment(0, 1), law.moment(0, 2), law.moment(0, 4)};
  one.solutions.push_back(solution);
  const auto cells = transform::average_over_cells(
      std::get<transform::SmoothDensity>(*solution.density), tests::uniform_edges(-6.5, 0.5, 35),
      tests::uniform_edges(-6, 7, 65));
  one.joints.push_back({"one", cells});
  add_moment_error_estimates(one, ResidualErrorEstimator(known), 1);
  ASSERT_EQ(one.moment_error_estimates.size(), 1u);
  EXPECT_NEAR(one.moment_error_estimates[0].corrected.y1, truth.moment(1, 0), 1e-7);
  EXPECT_NEAR(one.moment_error_estimates[0].corrected.y4, truth.moment(4, 0), 1e-6);
  EXPECT_NEAR(one.moment_error_estimates[0].error.y1, law.moment(1, 0) - truth.moment(1, 0), 1e-7);
  ASSERT_EQ(one.error_sources.size(), 2u);
  const auto& map = one.error_sources[0].density;
  EXPECT_EQ(map.y_edges, cells.y_edges);
  EXPECT_NEAR(integral(map), one.moment_error_estimates[0].error.y2, 1e-5);
  // The error sources vanish far from the density: at the low end of y.
  double low = 0, high = 0;
  for (std::size_t j = 0; j < map.v_cell_count(); ++j) {
    for (std::size_t i = 0; i < 5; ++i) {
      low = std::max(low, std::abs(map.cell_average(i, j)));
      high = std::max(high, std::abs(map.cell_average(map.y_cell_count() - 1 - i, j)));
    }
  }
  EXPECT_LT(low, 1e-3 * high);
}

TEST(MomentErrorEstimates, AreEmptyWithoutADensity) {
  auto cases =
      run_cases({tests::paper_case(1)},
                builtin_registry().methods_selected_by_list("mcs", {{"time", 2e3}}), 0, {});
  add_moment_error_estimates(cases.front(), ResidualErrorEstimator(tests::paper_case(1)), 0);
  EXPECT_TRUE(cases.front().moment_error_estimates.empty());
  EXPECT_TRUE(cases.front().error_sources.empty());
}

}  // namespace
}  // namespace fpkcheck::methods
