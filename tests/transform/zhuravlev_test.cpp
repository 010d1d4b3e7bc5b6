#include "transform/coordinate_transformation.hpp"

#include "transform/marginal_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fpkcheck::transform {
namespace {

// A correlated Gaussian without symmetry: z ~ N(0.4, 1), z' ~ N(z/2, 1).
ZhuravlevDensity skewed() {
  return {[](double x1, double x2) {
            const double u = x1 - 0.4, w = x2 - 0.5 * x1;
            return std::exp(-(u * u + w * w) / 2) / (2 * std::numbers::pi);
          },
          9.0, 12.0};
}

TEST(Zhuravlev, FoldsPointByPointThroughTheOrigin) {
  const ZhuravlevDensity plane = skewed();
  const SmoothDensity folded = zhuravlev_transform(plane);
  EXPECT_DOUBLE_EQ(folded.value(0.7, -0.3), plane.value(0.7, -0.3) + plane.value(-0.7, 0.3));
}

TEST(Zhuravlev, KeepsMassAndSecondMomentsOfTheUnfoldedPlane) {
  const SmoothDensity folded = zhuravlev_transform(skewed());
  EXPECT_NEAR(expectation(folded, [](double, double) { return 1.0; }), 1.0, 1e-9);
  const Moments m = marginals_at_quadrature_points(folded, folded.y_max, folded.v_max).moments;
  // y^2 = z^2 and y'^2 = z'^2; y y' = z z'.
  EXPECT_NEAR(m.y2, 1 + 0.16, 1e-8);
  EXPECT_NEAR(m.v2, 1 + 0.25 * 1.16, 1e-8);
  EXPECT_NEAR(expectation(folded, [](double y, double v) { return y * v; }), 0.5 * 1.16, 1e-8);
}

TEST(Zhuravlev, JointDensityOnAxesHasTheMassAndTheMarginalsOfTheFunction) {
  const SmoothDensity folded = zhuravlev_transform(skewed());
  std::vector<double> y_edges, v_edges;
  for (int k = 0; k <= 45; ++k) y_edges.push_back(0.2 * k);
  for (int k = -60; k <= 60; ++k) v_edges.push_back(0.2 * k);
  const GridDensity grid = average_over_cells(folded, y_edges, v_edges);
  EXPECT_NEAR(mass(grid), 1.0, 1e-9);
  EXPECT_NEAR(grid.cell_average(3, 50), folded.value(0.7, -1.9), 1e-3);
  for (const auto variable : {StateVariable::y, StateVariable::ydot}) {
    const auto& edges = variable == StateVariable::y ? y_edges : v_edges;
    const Marginal from_grid = marginal(grid, variable, edges);
    const Marginal from_function = marginal(folded, variable, edges);
    for (std::size_t b = 0; b < from_grid.size(); ++b) {
      EXPECT_NEAR(from_grid.density[b], from_function.density[b], 1e-8);
    }
  }
}

TEST(Zhuravlev, DisplacementMarginalIsTheSumOfBothBranches) {
  const std::vector<double> edges{0.5, 0.52};
  const Marginal p = marginal(zhuravlev_transform(skewed()), StateVariable::y, edges);
  const auto bell = [](double u) { return std::exp(-u * u / 2) / std::sqrt(2 * std::numbers::pi); };
  EXPECT_NEAR(p.density[0], bell(0.51 - 0.4) + bell(-0.51 - 0.4), 1e-4);
}

TEST(Zhuravlev, VelocityMarginalIsPaperEquation34) {
  const std::vector<double> edges{-0.81, -0.79};
  const ZhuravlevDensity plane = skewed();
  const Marginal p = marginal(zhuravlev_transform(plane), StateVariable::ydot, edges);
  double expected = 0;
  const int n = 40000;
  for (int i = 0; i < n; ++i) {
    const double z = 9.0 * (i + 0.5) / n;
    expected += (plane.value(z, -0.8) + plane.value(-z, 0.8)) * 9.0 / n;
  }
  EXPECT_NEAR(p.density[0], expected, 1e-4);
}

}  // namespace
}  // namespace fpkcheck::transform
