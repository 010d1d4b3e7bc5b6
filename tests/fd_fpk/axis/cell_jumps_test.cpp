#include "fd_fpk/axis/cell_jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {
namespace {

Axis uneven() {
  std::vector<double> faces;
  for (int i = -40; i <= 40; ++i) faces.push_back(i * 0.2 * (1 + 0.01 * std::abs(i)));
  return Axis(std::move(faces));
}

Eigen::VectorXd centres(const Axis& axis) {
  Eigen::VectorXd c(axis.cell_count());
  for (int i = 0; i < axis.cell_count(); ++i) c(i) = axis.cell_centre(i);
  return c;
}

TEST(CellJumpMatrices, KeepMassAndArePositive) {
  for (const auto* name : {"gaussian", "laplace", "two_point", "uniform"}) {
    const auto jumps = cell_jump_matrices(uneven(), problem::ImpulseLaw::from_name(name, 0.3, 0.8));
    const Eigen::VectorXd uniform = jumps.uniform.colwise().sum(),
                          slope = jumps.slope.colwise().sum();
    EXPECT_LT((uniform.array() - 1).abs().maxCoeff(), 1e-12) << name;
    EXPECT_LT(slope.cwiseAbs().maxCoeff(), 1e-12) << name;
    EXPECT_GE(jumps.uniform.minCoeff(), 0) << name;
  }
}

// A jump shifts the mean of a cell's mass by the mean of the law; a slope shifts the mean by the
// variance of a uniform distribution. The finite width of the target cells causes an error of
// second order.
TEST(CellJumpMatrices, ShiftTheMeanByTheLawAndTheSlope) {
  const Axis axis = uneven();
  const Eigen::VectorXd v = centres(axis);
  for (const auto* name : {"gaussian", "laplace", "uniform"}) {
    const auto jumps = cell_jump_matrices(axis, problem::ImpulseLaw::from_name(name, 0.3, 0.8));
    for (const int from : {35, 41, 47}) {
      EXPECT_NEAR(v.dot(jumps.uniform.col(from)), v(from) + 0.3, 5e-3) << name << " " << from;
      const double spread = std::pow(axis.cell_width(from), 2) / 12;
      EXPECT_NEAR(v.dot(jumps.slope.col(from)), spread, 0.05 * spread) << name << " " << from;
    }
  }
}

TEST(CellJumpMatrices, AtomsShiftAWholeCell) {
  const Axis axis = Axis::with_uniform_cells(-2, 0.1, 40);
  const auto jumps =
      cell_jump_matrices(axis, problem::ImpulseLaw::from_name("two_point", 0.02, 0.5));
  // -0.48 is 4.8 cells, 0.52 is 5.2.
  EXPECT_NEAR(jumps.uniform(20 - 5, 20), 0.4, 1e-12);
  EXPECT_NEAR(jumps.uniform(20 - 4, 20), 0.1, 1e-12);
  EXPECT_NEAR(jumps.uniform(20 + 5, 20), 0.4, 1e-12);
  EXPECT_NEAR(jumps.uniform(20 + 6, 20), 0.1, 1e-12);
  // For the part shifted by 5.2 cells, the upper fifth moves to the next cell.
  EXPECT_NEAR(jumps.slope(20 + 6, 20), 0.1 * 0.04, 1e-12);
  EXPECT_NEAR(jumps.slope(20 + 5, 20), -0.1 * 0.04, 1e-12);
}

TEST(CellJumpMatrices, JumpsBeyondTheAxisEndInItsLastCells) {
  const Axis axis = Axis::with_uniform_cells(-1, 0.1, 20);
  for (const auto* name : {"gaussian", "two_point"}) {
    const auto jumps = cell_jump_matrices(axis, problem::ImpulseLaw::from_name(name, 0, 5));
    EXPECT_NEAR(jumps.uniform(0, 10) + jumps.uniform(19, 10), 1, 0.2) << name;
    EXPECT_NEAR(jumps.uniform(0, 10), 0.5, 0.1) << name;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
