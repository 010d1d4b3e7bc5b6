#include "fd_fpk/line/cell_jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {
namespace {

Line uneven() {
  std::vector<double> faces;
  for (int i = -40; i <= 40; ++i) faces.push_back(i * 0.2 * (1 + 0.01 * std::abs(i)));
  return Line(std::move(faces));
}

Eigen::VectorXd centres(const Line& line) {
  Eigen::VectorXd c(line.cells());
  for (int i = 0; i < line.cells(); ++i) c(i) = line.centre(i);
  return c;
}

TEST(CellJumps, KeepMassAndArePositive) {
  for (const auto* name : {"gaussian", "laplace", "two_point", "uniform"}) {
    const auto jumps = cell_jumps(uneven(), problem::ImpulseLaw::named(name, 0.3, 0.8));
    const Eigen::VectorXd even = jumps.even.colwise().sum(), tilt = jumps.tilt.colwise().sum();
    EXPECT_LT((even.array() - 1).abs().maxCoeff(), 1e-12) << name;
    EXPECT_LT(tilt.cwiseAbs().maxCoeff(), 1e-12) << name;
    EXPECT_GE(jumps.even.minCoeff(), 0) << name;
  }
}

// A jump shifts the mean of a cell's mass by the mean of the law; a slope shifts it by the variance
// of a uniform distribution. The finite width of the target cells causes an error of second order.
TEST(CellJumps, MoveTheMeanByThatOfTheLawAndOfTheTilt) {
  const Line line = uneven();
  const Eigen::VectorXd v = centres(line);
  for (const auto* name : {"gaussian", "laplace", "uniform"}) {
    const auto jumps = cell_jumps(line, problem::ImpulseLaw::named(name, 0.3, 0.8));
    for (const int from : {35, 41, 47}) {
      EXPECT_NEAR(v.dot(jumps.even.col(from)), v(from) + 0.3, 5e-3) << name << " " << from;
      const double spread = std::pow(line.width(from), 2) / 12;
      EXPECT_NEAR(v.dot(jumps.tilt.col(from)), spread, 0.05 * spread) << name << " " << from;
    }
  }
}

TEST(CellJumps, AtomsMoveACellAsAWhole) {
  const Line line = Line::uniform(-2, 0.1, 40);
  const auto jumps = cell_jumps(line, problem::ImpulseLaw::named("two_point", 0.02, 0.5));
  // -0.48 is 4.8 cells, 0.52 is 5.2.
  EXPECT_NEAR(jumps.even(20 - 5, 20), 0.4, 1e-12);
  EXPECT_NEAR(jumps.even(20 - 4, 20), 0.1, 1e-12);
  EXPECT_NEAR(jumps.even(20 + 5, 20), 0.4, 1e-12);
  EXPECT_NEAR(jumps.even(20 + 6, 20), 0.1, 1e-12);
  // For the part shifted by 5.2 cells, the upper fifth moves to the next cell.
  EXPECT_NEAR(jumps.tilt(20 + 6, 20), 0.1 * 0.04, 1e-12);
  EXPECT_NEAR(jumps.tilt(20 + 5, 20), -0.1 * 0.04, 1e-12);
}

TEST(CellJumps, WhatWouldLeaveTheLineStaysInItsEnds) {
  const Line line = Line::uniform(-1, 0.1, 20);
  for (const auto* name : {"gaussian", "two_point"}) {
    const auto jumps = cell_jumps(line, problem::ImpulseLaw::named(name, 0, 5));
    EXPECT_NEAR(jumps.even(0, 10) + jumps.even(19, 10), 1, 0.2) << name;
    EXPECT_NEAR(jumps.even(0, 10), 0.5, 0.1) << name;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
