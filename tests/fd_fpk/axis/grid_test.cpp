#include "fd_fpk/axis/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

TEST(FacesByWidth, HoldAllAnchorsAndFillTheIntervalsBetweenThem) {
  const std::vector<double> anchors{-1, 0.25, 3};
  const auto width = [](double x) { return 0.01 + 0.2 * std::abs(x - 0.25); };
  const auto faces = cell_faces_from_width_function(anchors, width);
  for (const double anchor : anchors) {
    EXPECT_TRUE(std::ranges::find(faces, anchor) != faces.end()) << anchor;
  }
  for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
    const double cell = faces[f + 1] - faces[f], wanted = width((faces[f] + faces[f + 1]) / 2);
    EXPECT_LT(cell, 1.02 * wanted);
    EXPECT_GT(cell, 0.9 * wanted);
  }
}

TEST(FacesByWidth, AreOneCellWhereItIsWideEnough) {
  const std::vector<double> anchors{0, 1};
  EXPECT_EQ(cell_faces_from_width_function(anchors, [](double) { return 7.0; }), anchors);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
