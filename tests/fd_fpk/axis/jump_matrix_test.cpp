#include "fd_fpk/axis/jump_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "laws.hpp"
#include "paper_cases.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {
namespace {

double normal_distribution(double x, double mean, double deviation) {
  return 0.5 * std::erfc((mean - x) / (deviation * std::sqrt(2.0)));
}

Eigen::VectorXd normal_averages(const GridAxis& axis, double mean, double deviation) {
  Eigen::VectorXd averages(axis.cell_count());
  for (int i = 0; i < axis.cell_count(); ++i) {
    averages(i) = (normal_distribution(axis.face_position(i + 1), mean, deviation) -
                   normal_distribution(axis.face_position(i), mean, deviation)) /
                  axis.cell_width(i);
  }
  return averages;
}

TEST(JumpMatrix, ShiftsADensityByAnyAmplitude) {
  const GridAxis axis = GridAxis::with_uniform_cells(-6, 0.12, 100);
  for (const double amplitude : {0.12, -0.7, 1.234}) {
    const Eigen::VectorXd change =
        jump_matrix_of_fixed_amplitude(axis, amplitude) * normal_averages(axis, 0, 0.6);
    const Eigen::VectorXd exact =
        normal_averages(axis, amplitude, 0.6) - normal_averages(axis, 0, 0.6);
    EXPECT_LT((change - exact).cwiseAbs().maxCoeff(), 3e-7) << amplitude;
  }
}

TEST(JumpMatrix, AddsAGaussianImpulseToAGaussianVelocity) {
  // N(0.1, 0.6^2) + N(0.2, E[Y^2] - 0.2^2), on cells of equal and of unequal width.
  const auto law = tests::make_problem({.intensity = 0.5, .mean = 0.2}).impulses.amplitude_law();
  const double deviation = std::hypot(0.6, std::sqrt(0.5 - 0.04));
  const auto error = [&](int cells, const CellGrading& grading) {
    const auto positive = graded_cell_faces(8, cells / 2, grading);
    std::vector<double> faces;
    for (auto f = positive.rbegin(); f != positive.rend(); ++f) faces.push_back(-*f);
    faces.insert(faces.end(), positive.begin() + 1, positive.end());
    const GridAxis axis(faces);
    const Eigen::VectorXd change = jump_matrix(axis, law) * normal_averages(axis, 0.1, 0.6);
    const Eigen::VectorXd exact =
        normal_averages(axis, 0.3, deviation) - normal_averages(axis, 0.1, 0.6);
    return (change - exact).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(error(160, {}), 1e-8);
  EXPECT_LT(error(200, {0.6, 0.1}), 1e-8);
  // Order 8: the cumulative is interpolated with degree 7 and integrated against a smooth density.
  const double coarse = error(48, {}), middle = error(68, {}), fine = error(96, {});
  for (const double order : {2 * std::log2(coarse / middle), 2 * std::log2(middle / fine)}) {
    EXPECT_GT(order, 6.5) << coarse << " " << middle << " " << fine;
    EXPECT_LT(order, 10.5) << coarse << " " << middle << " " << fine;
  }
}

// Moments of the discrete operator about the centre of the source cell: E[Y^j], j = 0..6, for every
// law and any ratio of cell width to impulse.
TEST(JumpMatrix, HasTheMomentsOfEveryImpulseLaw) {
  for (const auto* name : {"gaussian", "laplace", "two_point", "uniform"}) {
    for (const double deviation : {0.05, 0.3, 1.0}) {
      const auto law = problem::ImpulseLaw::from_name(name, 0.3 * deviation, deviation);
      // The axis is as short as possible, because the rounding error of a cell enters the moments
      // with the sixth power of the distance of the cell.
      const double reach = law.amplitude_density_breakpoints().empty()
                               ? 2
                               : law.amplitude_density_breakpoints().back();
      const int half = static_cast<int>(reach / 0.12) + 6;
      const GridAxis axis = GridAxis::with_uniform_cells(-(half + 0.5) * 0.12, 0.12, 2 * half + 1);
      const Eigen::VectorXd rates = jump_matrix(axis, law).col(half);
      for (int j = 0; j <= 6; ++j) {
        double moment = 0;
        for (int to = 0; to < axis.cell_count(); ++to) {
          moment += rates(to) * std::pow(axis.cell_centre(to), j);
        }
        const double exact = j == 0 ? 0 : law.moment(j);
        const double rounding = 1e-14 * std::pow(axis.faces().back(), j);
        EXPECT_NEAR(moment, exact, 1e-10 * std::abs(exact) + rounding)
            << name << " " << j << " " << deviation;
      }
    }
  }
}

// The change E[C(x - Y)] - C(x) of the normal distribution C: the sum of (-1)^k E[Y^k]/k! times the
// derivatives of C, which are Hermite polynomials times the density.
double change_of_normal_distribution(const problem::ImpulseLaw& law, double x, double deviation) {
  const double z = x / deviation, density = std::exp(-z * z / 2) / std::sqrt(2 * M_PI);
  double sum = 0, before = 0, hermite = 1, factorial = 1;
  for (int k = 1; k <= 20; ++k) {
    factorial *= k;
    const double derivative = (k % 2 == 1 ? 1 : -1) * hermite * density / std::pow(deviation, k);
    sum += (k % 2 == 1 ? -1 : 1) * law.moment(k) / factorial * derivative;
    const double next = z * hermite - (k - 1) * before;
    before = hermite;
    hermite = next;
  }
  return sum;
}

// Frequent impulses of a given intensity are small. Piecewise interpolation has kinks at the faces.
// As lambda E|Y| ~ 1 / E|Y|, these kinks caused an error of 3 % for impulses of a hundredth of a
// cell width.
TEST(JumpMatrix, ImpulsesShorterThanCellsActByTheirMoments) {
  constexpr double kWidth = 0.12, kDeviation = 0.6;
  const GridAxis axis = GridAxis::with_uniform_cells(-4.8, kWidth, 80);
  const Eigen::VectorXd averages = normal_averages(axis, 0, kDeviation);
  for (const auto& name : tests::law_names_without_table()) {
    for (const double cells : {0.25, 0.1, 1e-2, 1e-4, 1e-7}) {
      const double deviation = cells * kWidth;
      const auto law = problem::ImpulseLaw::from_name(name, 0.2 * deviation, deviation);
      const Eigen::VectorXd change = jump_matrix(axis, law) * averages / law.moment(2);
      double largest = 0, error = 0;
      for (int i = 0; i < axis.cell_count(); ++i) {
        const double exact =
            (change_of_normal_distribution(law, axis.face_position(i + 1), kDeviation) -
             change_of_normal_distribution(law, axis.face_position(i), kDeviation)) /
            kWidth / law.moment(2);
        largest = std::max(largest, std::abs(exact));
        error = std::max(error, std::abs(change(i) - exact));
      }
      EXPECT_LT(error, 1e-5 * largest) << name << " " << cells;
    }
  }
}

TEST(JumpMatrix, JumpsBeyondTheAxisDoNotTakePlace) {
  const auto law = tests::make_problem({.intensity = 4}).impulses.amplitude_law();
  const GridAxis axis = GridAxis::with_uniform_cells(-1, 0.1, 20);
  const Eigen::MatrixXd jump = jump_matrix(axis, law);
  EXPECT_LT((axis.cell_widths().transpose() * jump).cwiseAbs().maxCoeff(), 1e-13);
  // From the middle cell jumps with |Y| < 1 take place: a fraction erf(1/(2 sqrt 2)).
  EXPECT_NEAR(-jump.diagonal()(10), std::erf(1 / (2 * std::sqrt(2.0))), 0.03);
}

GridAxis uneven() {
  std::vector<double> faces;
  for (int i = -40; i <= 40; ++i) faces.push_back(i * 0.2 * (1 + 0.01 * std::abs(i)));
  return GridAxis(std::move(faces));
}

Eigen::VectorXd centres(const GridAxis& axis) {
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
  const GridAxis axis = uneven();
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
  const GridAxis axis = GridAxis::with_uniform_cells(-2, 0.1, 40);
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
  const GridAxis axis = GridAxis::with_uniform_cells(-1, 0.1, 20);
  for (const auto* name : {"gaussian", "two_point"}) {
    const auto jumps = cell_jump_matrices(axis, problem::ImpulseLaw::from_name(name, 0, 5));
    EXPECT_NEAR(jumps.uniform(0, 10) + jumps.uniform(19, 10), 1, 0.2) << name;
    EXPECT_NEAR(jumps.uniform(0, 10), 0.5, 0.1) << name;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
