#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dense_eigenvalues.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

struct Discrete {
  FokkerPlanckOperator op;
  FastestGrowingWave symbol;
  double frequency;
  PhasePlaneGrid grid;
};

// Discretises with cells of this width in y', in a box small enough for dense matrices.
Discrete discrete(const problem::Problem& problem, FiniteVolumeOptions options, double step,
                  int nx = 16, double half_height = 2.5) {
  const auto linear = problem::equivalent_linearisation(problem);
  options.origin_refinement = 1;
  options.nx = nx;
  options.nv = 2 * std::max(8, static_cast<int>(half_height / step));
  const PhasePlaneBox box{4.5 * linear.displacement_deviation, *options.nv * step / 2};
  const auto on = discretise_density_equation(problem, options, box);
  return {fokker_planck_operator(problem, options, on),
          fastest_growing_wave(problem, options, step), std::sqrt(linear.stiffness), on.grid};
}

TEST(RightmostEigenvalue, AgreesWithADenseSolverForEveryEquation) {
  const double s = std::sqrt(0.1);
  struct Case {
    const char* name;
    FiniteVolumeOptions options;
    double restitution;
    double step;
    double guess;  // guess of the growth rate, relative to that of the symbol
  };
  for (const auto& [name, options, restitution, step, guess] :
       {Case{"white", {.equation = DensityEquation::white}, 0.98, 0.2, 1},
        Case{"literal",
             {.equation = DensityEquation::km4, .regularisation_length = 0},
             0.98,
             s / 2,
             1},
        Case{"literal, guessed badly",
             {.equation = DensityEquation::km4, .regularisation_length = 0},
             0.7,
             s / 2,
             0.3},
        Case{"regularised", {.equation = DensityEquation::km4}, 0.98, s / 2, 1},
        Case{"kf", {.equation = DensityEquation::kf}, 0.6, 0.2, 1}}) {
    const auto p = tests::make_problem({.restitution = restitution});
    const Discrete d = discrete(p, options, step);
    const auto expected = tests::dense_eigenvalues(d.op.assembled_matrix());
    const bool growing = is_growing_wave(d.symbol, p.impulses);
    const int count = growing ? 1 : 2;
    const auto found =
        find_rightmost_eigenvalues(d.op, growing ? guess * d.symbol.rate : 0, d.frequency, count);
    ASSERT_EQ(found.values.size(), static_cast<std::size_t>(count)) << name << found.failure;
    const double unit = std::max(d.frequency, d.symbol.rate);
    for (int k = 0; k < count; ++k) {
      EXPECT_LT(std::abs(found.values[k] - expected[k]), 1e-8 * unit)
          << name << ": " << found.values[k] << " " << expected[k];
    }
    EXPECT_LT(found.residual, 1e-6 * unit) << name;
    EXPECT_NEAR(found.vector.norm(), 1, 1e-12) << name;
  }
}

// A matrix with rightmost eigenvalues 0.5 +- 30 i, far from any shift near the real axis, where
// fifty other eigenvalues are.
TEST(RightmostEigenvalue, IsFoundFarUpTheImaginaryAxis) {
  constexpr int kSize = 300;
  SparseColumnMatrix matrix(kSize, kSize);
  for (int k = 0; k < kSize - 2; ++k) matrix.insert(k, k) = -0.02 * k;
  matrix.insert(kSize - 2, kSize - 2) = matrix.insert(kSize - 1, kSize - 1) = 0.5;
  matrix.insert(kSize - 2, kSize - 1) = 30;
  matrix.insert(kSize - 1, kSize - 2) = -30;
  matrix.makeCompressed();
  const FokkerPlanckOperator op{matrix, {}, Eigen::VectorXd::Ones(kSize)};
  const auto found = find_rightmost_eigenvalues(op, 0, 1, 2);
  ASSERT_EQ(found.values.size(), 2u) << found.failure;
  EXPECT_LT(std::abs(found.values[0] - std::complex(0.5, 30.0)), 1e-7) << found.values[0];
  EXPECT_LT(std::abs(found.values[1]), 1e-7) << found.values[1];
}

TEST(RightmostEigenvalue, OfAWellPosedOperatorIsZeroAndItsVectorTheStationaryDensity) {
  const auto p = tests::make_problem({.restitution = 0.8});
  const Discrete d = discrete(p, {.equation = DensityEquation::km4}, 0.16, 20, 4.0);
  const auto found = find_rightmost_eigenvalues(d.op, 0, d.frequency, 2);
  ASSERT_EQ(found.values.size(), 2u) << found.failure;
  EXPECT_LT(std::abs(found.values[0]), 1e-11);
  const auto stationary =
      find_null_vector_by_inverse_iteration(
          d.op, initial_gaussian(d.grid, problem::motion_scales(p)), d.frequency)
          .averages;
  ASSERT_TRUE(stationary);
  Eigen::VectorXd real = found.vector.real();
  real /= d.op.total_mass(real);
  EXPECT_LT((real - *stationary).cwiseAbs().maxCoeff(), 1e-9 * stationary->maxCoeff());
  // Densities are even under (z, z') -> (-z, -z'). Therefore only modes that combine an even number
  // of the linear oscillator's modes remain, and the slowest of these modes decays twice as fast as
  // a single mode.
  const double single = problem::slowest_decay_rate(problem::equivalent_linearisation(p));
  EXPECT_NEAR(-found.values[1].real() / (2 * single), 1.0, 0.15);
}

// The shortest waves have the highest growth rate, which upwind transport reduces slightly.
TEST(RightmostEigenvalue, OfTheLiteralSchemeApproachesTheSymbolFromBelow) {
  const auto p = tests::make_problem();
  const double s = std::sqrt(0.1);
  double last = 1;
  for (const double step : {s / 2, s / 3, s / 4, s / 6}) {
    const Discrete d =
        discrete(p, {.equation = DensityEquation::km4, .regularisation_length = 0}, step, 16);
    const auto found = find_rightmost_eigenvalues(d.op, d.symbol.rate, d.frequency, 1);
    ASSERT_EQ(found.values.size(), 1u) << found.failure;
    const double missing = 1 - found.values[0].real() / d.symbol.rate;
    EXPECT_GT(missing, 0) << step;
    EXPECT_LT(missing, 0.5 * last) << step;  // 0.17, 0.04, 0.016, 0.004
    last = missing;
  }
  EXPECT_LT(last, 0.006);
  EXPECT_GT(last, 0.002);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
