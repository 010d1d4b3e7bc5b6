#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solved_run.hpp"
#include "workflows/check/quantities.hpp"

namespace fpkcheck::check {
namespace {

using results::Curve;
using tests::moved_by;

Curve& simulated_curve(results::Run& run) {
  return *std::ranges::find(run.cases[0].curves, "mcs", &Curve::solution);
}

TEST(MarginalFigures, FindsEveryBinOfACurve) {
  const auto& curve = tests::paper_baseline().cases[0].curves.front();
  const double peak = std::ranges::max(curve.density);
  const auto runs = tests::alone(curve.solution);
  for (std::size_t k = 0; k < curve.density.size(); ++k) {
    for (const double sign : {-1.0, 1.0}) {
      const auto moved = moved_by(
          [&](results::Run& run) { run.cases[0].curves.front().density[k] += sign * 1e-7 * peak; },
          {}, runs);
      ASSERT_EQ(moved.size(), 1u) << k;
      EXPECT_EQ(moved[0].kind, QuantityKind::marginal);
      EXPECT_NEAR(moved[0].change, 1e-7, 1e-13);
      EXPECT_NE(moved[0].name.find(fmt::format("{:.4g}", curve.abscissa[k])), std::string::npos);
    }
  }
}

TEST(MarginalFigures, CurvesOnOtherBinsCannotBeCompared) {
  const auto moved = moved_by([](results::Run& run) {
    for (double& x : run.cases[0].curves.front().abscissa) x *= 1.001;
  });
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_TRUE(std::isinf(moved[0].change));
}

TEST(MarginalFigures, SimulatedBinsHaveToleranceByIntervalAndNumberOfBins) {
  const auto by = [](double errors) {
    return moved_by([&](results::Run& run) {
      Curve& curve = simulated_curve(run);
      const double error = (curve.upper[20] - curve.density[20]) / 1.96;
      for (auto* values : {&curve.density, &curve.lower, &curve.upper}) {
        (*values)[20] += errors * std::sqrt(2.0) * error;
      }
    });
  };
  EXPECT_EQ(by(4.5).size(), 0u);  // within the threshold for the largest of all bins
  ASSERT_EQ(by(5.2).size(), 1u);
  EXPECT_EQ(by(5.2)[0].kind, QuantityKind::simulated_bin);
  EXPECT_GT(by(5.2)[0].allowed, 4.7);
  EXPECT_LT(by(5.2)[0].allowed, 5.1);
}

TEST(MarginalFigures, FindsAnotherShapeOfASimulationByL1) {
  const auto moved = moved_by([](results::Run& run) {
    Curve& curve = simulated_curve(run);  // too low near the wall, too high far from it
    for (std::size_t k = 0; k < curve.density.size(); ++k) {
      const double tilt = 0.05 * (curve.abscissa[k] - 0.5);
      for (auto* values : {&curve.density, &curve.lower, &curve.upper}) (*values)[k] *= 1 + tilt;
    }
  });
  EXPECT_TRUE(std::ranges::any_of(moved, [](const QuantityChange& quantity_change) {
    return quantity_change.kind == QuantityKind::simulated_l1;
  }));
}

}  // namespace
}  // namespace fpkcheck::check
