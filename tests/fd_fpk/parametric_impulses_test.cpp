// Parametric impulses, which change y' by b(y) Y: the operator against jumps of a normal density,
// and exact moments of a linear oscillator.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/operator/parametric_exchange.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/solve.hpp"
#include "general_oscillators.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::fd_fpk {
namespace {

problem::Problem with_factor(const std::string& factor, const std::string& law = "gaussian",
                             const std::string& walls = "none = true",
                             const std::string& more = "") {
  std::istringstream ini("[system]\nforce = 0.5*v + y\n[wall]\n" + walls +
                         "\n[impulse]\nrate = 1\nlaw = " + law +
                         "\nintensity = 0.5\nfactor = " + factor + '\n' + more);
  return tests::in_wall_coordinates(
      problem::read_case(ini, "test", "test.ini", {}, problem::CaseNamingRule::with_overrides));
}

double normal(double x, double variance) {
  return std::exp(-x * x / (2 * variance)) / std::sqrt(2 * std::numbers::pi * variance);
}

Eigen::VectorXd rate_of_jumps(const problem::Problem& problem, const PhasePlaneGrid& grid,
                              const Eigen::VectorXd& averages) {
  FokkerPlanckOperator op{
      .local = SparseColumnMatrix(grid.size(), grid.size()),
      .exchange = parametric_exchange_terms({problem.impulses, *problem.impulse_factor}, grid, 5),
      .areas = grid.cell_areas()};
  EXPECT_LT(op.max_mass_loss_rate(), 1e-12);
  EXPECT_NEAR((op.assembled_matrix() * averages - op * averages).cwiseAbs().maxCoeff(), 0, 1e-12);
  return op * averages;
}

// Returns the averages of a function over the cells, by the rule of Gauss with three points.
template <class Function>
Eigen::VectorXd cell_averages(const PhasePlaneGrid& grid, const Function& f) {
  const double at[] = {-std::sqrt(0.15), 0, std::sqrt(0.15)},
               weight[] = {5 / 18.0, 8 / 18.0, 5 / 18.0};
  Eigen::VectorXd averages = Eigen::VectorXd::Zero(grid.size());
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          averages(i * grid.v_cell_count() + j) +=
              weight[a] * weight[b] *
              f(grid.x1.cell_centre(i) + at[a] * grid.x1.cell_width(i),
                grid.x2.cell_centre(j) + at[b] * grid.x2.cell_width(j));
        }
      }
    }
  }
  return averages;
}

// A normal density of v is convolved with the normal law of b Y, of variance b^2 E[Y^2]. The error
// decreases with the order 5 of the averages over x1, or faster.
TEST(ParametricImpulses, ConvolveTheDensityWithTheLawOfTheirAmplitude) {
  const problem::Problem problem = with_factor("1 + 0.4*y");
  double errors[3];
  for (int level = 0; level < 3; ++level) {
    const int cells = 16 << level;
    const PhasePlaneGrid grid = symmetric_grid(
        GridAxis::with_uniform_cells(-6, 12.0 / cells, cells).faces(),
        graded_cell_faces(9, cells, {}), AxisEndCondition::vacuum, AxisEndCondition::vacuum);
    const Eigen::VectorXd p =
        cell_averages(grid, [](double y, double v) { return normal(y, 1) * normal(v, 1); });
    const Eigen::VectorXd exact = cell_averages(grid, [](double y, double v) {
      const double b = 1 + 0.4 * y;
      return normal(y, 1) * (normal(v, 1 + 0.5 * b * b) - normal(v, 1));
    });
    errors[level] = (rate_of_jumps(problem, grid, p) - exact).cwiseAbs().dot(grid.cell_areas());
  }
  for (int level = 0; level < 2; ++level) {
    const double order = std::log2(errors[level] / errors[level + 1]);
    EXPECT_GT(order, 3.8) << errors[level] << ' ' << errors[level + 1];
    EXPECT_LT(order, 7) << errors[level] << ' ' << errors[level + 1];
  }
  EXPECT_LT(errors[2], 1e-5);
}

// A factor below 0 reverses a skew law: d/dt E[v^3 | y] = b^3 lambda E[Y^3] at E[v] = 0.
TEST(ParametricImpulses, OfNegativeFactorReverseTheLaw) {
  const problem::Problem problem = with_factor("1.1*tanh(y) - 0.3", "exponential");
  const PhasePlaneGrid grid = symmetric_grid(GridAxis::with_uniform_cells(-6, 0.25, 48).faces(),
                                             graded_cell_faces(14, 60, {}),
                                             AxisEndCondition::vacuum, AxisEndCondition::vacuum);
  const Eigen::VectorXd p =
      cell_averages(grid, [](double y, double v) { return normal(y, 1) * normal(v, 1); });
  const Eigen::VectorXd rate = rate_of_jumps(problem, grid, p);
  const double third = problem.impulses.amplitude_law().moment(3);
  ASSERT_GT(third, 0.5);
  for (const int i : {16, 20, 24, 28}) {
    const double y = grid.x1.cell_centre(i), b = 1.1 * std::tanh(y) - 0.3;
    double skew = 0;
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      const double low = grid.x2.face_position(j), high = grid.x2.face_position(j + 1);
      skew += rate(i * grid.v_cell_count() + j) * (std::pow(high, 4) - std::pow(low, 4)) / 4;
    }
    EXPECT_NEAR(skew / normal(y, 1), b * b * b * third, 0.02 * third) << y;
  }
}

// For y'' + c y' + k y and b = 1 + e y: E[y^2] = I / (2 c k - I e^2), E[v^2] = k E[y^2], for any
// law of mean 0 and for white noise of the same intensity.
void expect_exact_moments(const problem::Problem& problem, const FiniteVolumeOptions& options,
                          double y2) {
  const auto [solution, summary] = solve_stationary_density(problem, options);
  ASSERT_EQ(solution.status, transform::Status::ok) << solution.reason;
  ASSERT_TRUE(summary.error);
  EXPECT_NEAR(solution.moments.y2, y2, 2 * summary.error->moments.y2 + 1e-9);
  EXPECT_NEAR(solution.moments.v2, y2, 2 * summary.error->moments.v2 + 1e-9);
  EXPECT_LT(summary.error->moments.y2, 2e-3 * y2);
}

const double kExact = 0.5 / (1 - 0.5 * 0.16);

TEST(ParametricImpulses, OfGaussianLawHaveTheExactMoments) {
  expect_exact_moments(with_factor("1 + 0.4*y"), {.max_seconds = 120}, kExact);
}

TEST(ParametricImpulses, OfTwoAmplitudesHaveTheExactMoments) {
  expect_exact_moments(with_factor("1 - 0.4*y", "two_point"), {.max_seconds = 120}, kExact);
}

TEST(ParametricImpulses, AsWhiteNoiseHaveTheExactMoments) {
  expect_exact_moments(with_factor("1 + 0.4*y"),
                       {.equation = DensityEquation::white, .max_seconds = 120}, kExact);
  // Noise of intensity 0.2 adds to the intensity of the impulses.
  expect_exact_moments(
      with_factor("1 + 0.4*y", "gaussian", "none = true", "[noise]\nintensity = 0.2\n"),
      {.equation = DensityEquation::white, .max_seconds = 120}, 0.7 / (1 - 0.5 * 0.16));
}

// The factor 1 as a formula gives the jumps without a factor, to the error of the interpolation in
// b, which is of degree 5.
TEST(ParametricImpulses, OfFactorOneAreImpulses) {
  const problem::Problem one = with_factor("1"),
                         plain = tests::with_impulses(one.system, one.impulses);
  double differences[3];
  for (int level = 0; level < 3; ++level) {
    const int cells = 24 << level;
    const FiniteVolumeOptions options{.nx = cells, .nv = cells, .x1_max = 5, .x2_max = 5};
    const PlaneDiscretisation of_factor = discretise_density_equation(one, options,
                                                                      initial_box(one, options)),
                              of_none = discretise_density_equation(plain, options,
                                                                    initial_box(plain, options));
    const Eigen::VectorXd p = cell_averages(
        of_none.grid, [](double y, double v) { return normal(y - 0.3, 0.5) * normal(v, 0.6); });
    differences[level] = (fokker_planck_operator(one, options, of_factor) * p -
                          fokker_planck_operator(plain, options, of_none) * p)
                             .cwiseAbs()
                             .maxCoeff();
  }
  for (int level = 0; level < 2; ++level) {
    EXPECT_GT(std::log2(differences[level] / differences[level + 1]), 4.5)
        << differences[level] << ' ' << differences[level + 1];
  }
  EXPECT_LT(differences[2], 1e-6);
}

TEST(ParametricImpulses, AreRefusedWithAReasonWhereTheyAreNotSupported) {
  const problem::Problem free = with_factor("1 + 0.4*y");
  EXPECT_EQ(unsupported_reason(free, {}), "");
  EXPECT_EQ(unsupported_reason(free, {.equation = DensityEquation::white}), "");
  EXPECT_NE(unsupported_reason(free, {.equation = DensityEquation::km4}).find("impulse.factor"),
            std::string::npos);
  EXPECT_NE(
      unsupported_reason(free, {.transport = TransportScheme::characteristics}).find("factor"),
      std::string::npos);
  EXPECT_EQ(transient_unsupported_reason(free, {}), "");
  const std::string inside = "left = -0.5\nleft_restitution = 0.8";
  EXPECT_EQ(unsupported_reason(with_factor("1 + 0.4*y", "gaussian", inside), {}), "");
  const std::string pressed = "left = 0.5\nleft_restitution = 0.8";
  EXPECT_NE(unsupported_reason(with_factor("1 + 0.4*y", "gaussian", pressed), {}).find("factor"),
            std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
