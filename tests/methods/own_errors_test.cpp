#include "methods/own_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "methods/builtin.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::methods {
namespace {

constexpr double kTrueY2 = 0.3945181772, kTrueV2 = 0.4415122125;  // of case 1, to 7e-10

double integral(const transform::GridDensity& map) {
  double sum = 0;
  for (std::size_t i = 0; i < map.ny(); ++i) {
    for (std::size_t j = 0; j < map.nv(); ++j) {
      sum += map.average(i, j) * (map.y_edges[i + 1] - map.y_edges[i]) *
             (map.v_edges[j + 1] - map.v_edges[j]);
    }
  }
  return sum;
}

TEST(OwnErrors, OfEverySolutionCorrectItToTheTruth) {
  auto cases =
      run_cases({tests::paper_case(1)},
                builtin().select("epc-gaussian-n2,epc-gaussian-n6,epc-moment-n8,fd-white,fd-kf,mcs",
                                 {{"time", 2e4}}),
                0, {});
  add_own_errors(cases.front(), ProblemResiduals(tests::paper_case(1)), 0);
  const auto& one = cases.front();
  ASSERT_EQ(one.own_errors.size(), 5u);  // not of the histogram
  ASSERT_EQ(one.error_sources.size(), 10u);
  for (const auto& own : one.own_errors) {
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
      // The solver's moments and those of its density differ by quadrature; what lies beyond the
      // cells is lost.
      EXPECT_NEAR(integral(source.density), error, 5e-6 + 2e-3 * std::abs(error));
    }
  }
}

TEST(OwnErrors, AreNoneWithoutADensity) {
  auto cases = run_cases({tests::paper_case(1)}, builtin().select("mcs", {{"time", 2e3}}), 0, {});
  add_own_errors(cases.front(), ProblemResiduals(tests::paper_case(1)), 0);
  EXPECT_TRUE(cases.front().own_errors.empty());
  EXPECT_TRUE(cases.front().error_sources.empty());
}

}  // namespace
}  // namespace fpkcheck::methods
