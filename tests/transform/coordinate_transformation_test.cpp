#include "transform/coordinate_transformation.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::transform {
namespace {

const problem::WallFrame kShifted{.origin = -0.5, .mirrored = false};
const problem::WallFrame kMirrored{.origin = 2, .mirrored = true};

// 2 x 3 cells over (x, x') with the averages 1 .. 6, row by row.
const GridDensity kGrid{{0, 1, 3}, {-2, -1, 0, 4}, {1, 2, 3, 4, 5, 6}};

const GridDensity& grid_of(const Density& density) { return std::get<GridDensity>(density); }

TEST(ChangeOfFrame, ShiftsCells) {
  const Density density = to_physical_coordinates(kShifted, kGrid);
  EXPECT_EQ(grid_of(density).y_edges, (std::vector<double>{-0.5, 0.5, 2.5}));
  EXPECT_EQ(grid_of(density).v_edges, kGrid.v_edges);
  EXPECT_EQ(grid_of(density).averages, kGrid.averages);
}

// y = 2 - x, y' = -x': the first cell becomes the last cell in both directions.
TEST(ChangeOfFrame, MirrorsCellsInBothDirections) {
  const Density density = to_physical_coordinates(kMirrored, kGrid);
  EXPECT_EQ(grid_of(density).y_edges, (std::vector<double>{-1, 1, 2}));
  EXPECT_EQ(grid_of(density).v_edges, (std::vector<double>{-4, 0, 1, 2}));
  EXPECT_EQ(grid_of(density).averages, (std::vector<double>{6, 5, 4, 3, 2, 1}));
}

TEST(ChangeOfFrame, MirrorsFunctionsWithTheirSupport) {
  const Density density = to_physical_coordinates(
      kMirrored, SmoothDensity{[](double x, double v) { return 10 * x + v; }, 3, 7});
  const auto& smooth = std::get<SmoothDensity>(density);
  EXPECT_EQ(smooth.y_min, -1);
  EXPECT_EQ(smooth.y_max, 2);
  EXPECT_EQ(smooth.v_max, 7);
  EXPECT_EQ(smooth.value(1.5, 0.25), 10 * 0.5 - 0.25);
}

TEST(ChangeOfFrame, EdgesAreTransformedBack) {
  const std::vector<double> y{-1, 0.5, 2};
  EXPECT_EQ(wall_coordinate_edges(kMirrored, y), (std::vector<double>{0, 1.5, 3}));
  EXPECT_EQ(y_edges_from_wall_coordinates(kMirrored, wall_coordinate_edges(kMirrored, y)), y);
}

TEST(ChangeOfFrame, TransformsMarginalsWithIntervalsAndAtoms) {
  Solution solution;
  solution.density = kGrid;
  solution.estimated_marginals = {
      {StateVariable::y,
       {.edges = {0, 1, 3}, .density = {0.1, 0.2}, .lower = {0.05, 0.15}, .upper = {0.2, 0.3}}},
      {StateVariable::ydot,
       {.edges = {-1, 0, 2}, .density = {0.3, 0.4}, .lower = {}, .upper = {}}}};
  solution.atoms = {{.y = 0, .probability = 0.25}};
  const Solution transformed = to_physical_coordinates(kMirrored, solution);
  const Marginal& y = transformed.estimated_marginals[0].second;
  EXPECT_EQ(y.edges, (std::vector<double>{-1, 1, 2}));
  EXPECT_EQ(y.density, (std::vector<double>{0.2, 0.1}));
  EXPECT_EQ(y.lower, (std::vector<double>{0.15, 0.05}));
  const Marginal& ydot = transformed.estimated_marginals[1].second;
  EXPECT_EQ(ydot.edges, (std::vector<double>{-2, 0, 1}));
  EXPECT_EQ(ydot.density, (std::vector<double>{0.4, 0.3}));
  EXPECT_EQ(transformed.atoms[0].y, 2);
}

}  // namespace
}  // namespace fpkcheck::transform
