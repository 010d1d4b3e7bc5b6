#include "transform/solver_metric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "transform/marginal_density.hpp"

namespace fpkcheck::transform {
namespace {

TEST(BalanceResiduals, AreMetricsWithTheirErrors) {
  SolverMetricsBuilder builder;
  add_balance_metrics(builder, {.virial = 1e-3, .momentum = -2e-3},
                      {.virial = {}, .momentum = 5e-4});
  const auto metrics = builder.take_metrics();
  EXPECT_EQ(metric_number(metrics, "balances.virial"), 1e-3);
  EXPECT_EQ(metric_number(metrics, "balances.momentum"), -2e-3);
  EXPECT_EQ(metric_number(metrics, "balances.momentum_error"), 5e-4);
  EXPECT_EQ(find_metric(metrics, "balances.momentum")->standard_error_path,
            "balances.momentum_error");
  EXPECT_EQ(find_metric(metrics, "balances.virial_error"), nullptr);
}

TEST(BalanceResiduals, AreNullIfAbsent) {
  SolverMetricsBuilder builder;
  add_balance_metrics(builder, {});
  const auto metrics = builder.take_metrics();
  ASSERT_NE(find_metric(metrics, "balances.virial"), nullptr);
  EXPECT_FALSE(metric_number(metrics, "balances.virial"));
  EXPECT_FALSE(metric_number(metrics, "balances.momentum"));
}

// Half-normal density: E[y] = sqrt(2/pi), E[y^2] = 1, E[y^3] = 2 sqrt(2/pi).
TEST(QuadratureMarginals, ComputeTheMeanOfAPolynomial) {
  const SmoothDensity bell{
      [](double y, double v) { return std::exp(-(y * y + v * v) / 2) / std::numbers::pi; }, 9.0,
      9.0};
  const double mean = std::sqrt(2 / std::numbers::pi);
  for (const auto panels : {QuadraturePanelSpacing::uniform, QuadraturePanelSpacing::graded,
                            QuadraturePanelSpacing::geometric}) {
    const auto marginals = marginals_at_quadrature_points(bell, bell.y_max, bell.v_max, panels);
    EXPECT_NEAR(mean_of_displacement_polynomial(marginals, numerics::Polynomial({0, 3, 0, 0.5})),
                4 * mean, 1e-8);
    EXPECT_NEAR(mean_of_displacement_polynomial(
                    marginals, numerics::Polynomial({0, 3}).multiplied_by_argument()),
                3, 1e-8);
  }
}

// Two Gaussians of equal mass, with widths 1 and 1/1000, modulated by the direction from the
// origin.
TEST(QuadratureMarginals, GeometricPanelsResolveASelfSimilarSpike) {
  const auto bell = [](double rho, double width) {
    return std::exp(-rho * rho / (2 * width * width)) / (2 * std::numbers::pi * width * width);
  };
  const SmoothDensity fan{[&](double y, double v) {
                            const double rho = std::hypot(y, v);
                            return (1 + std::sin(std::atan2(v, y)) / 2) *
                                   (bell(rho, 1) + bell(rho, 1e-3));
                          },
                          8.0, 8.0};
  const auto mass = [&](QuadraturePanelSpacing panels) {
    return marginals_at_quadrature_points(fan, fan.y_max, fan.v_max, panels).mass;
  };
  EXPECT_NEAR(mass(QuadraturePanelSpacing::geometric), 1, 1e-4);
  EXPECT_GT(std::abs(mass(QuadraturePanelSpacing::graded) - 1), 1e-3);
  EXPECT_GT(std::abs(mass(QuadraturePanelSpacing::uniform) - 1), 1e-2);
}

}  // namespace
}  // namespace fpkcheck::transform
