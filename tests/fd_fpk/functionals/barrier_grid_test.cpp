#include "fd_fpk/functionals/barrier_grid.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include "exact/random_acceleration.hpp"
#include "general_oscillators.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::System;
using LowerEnd = PassageStrip::LowerEnd;

struct Values {
  double mean_time, upper_exit;
};
// Returns the values of a start at (y, v) on a grid.
Values values_from(const problem::Problem& problem, const PassageStrip& strip, double y, double v,
                   int displacement_count, int velocity_count) {
  const auto excitation = BackwardEquationExcitation::of_equation(problem, DensityEquation::white);
  const BarrierGrid grid(problem, excitation, strip, displacement_count, velocity_count);
  const auto [matrix, upper_exit_terms] = grid.backward_system();
  const Eigen::SparseLU<SparseColumnMatrix> lu(matrix);
  const Eigen::VectorXd times = lu.solve(Eigen::VectorXd::Constant(grid.size(), -1)),
                        exits = lu.solve(-upper_exit_terms),
                        at = grid.interpolation_weights_at_state(y, v);
  return {at.dot(times), at.dot(exits)};
}

// x'' = xi of intensity 2D = 1, reflected at 0
problem::Problem random_acceleration(double restitution) {
  return tests::with_noise(
      System({.damping = 0, .stiffness = 0}, {.left = 0, .left_restitution = restitution}), 1);
}

// By symmetry y = |x| with an elastic wall leaves (0, 1) when x leaves (-1, 1). The singularities
// at (1, 0) do not reduce the order of convergence below 2.3.
TEST(BarrierGrid, ConvergesToTheExactExitTimesBehindAnElasticWall) {
  const PassageStrip strip{LowerEnd::wall, 0, 1, 6};
  const problem::Problem problem = random_acceleration(1);
  for (const double y : {0.0, 0.5}) {
    const double exact = exact::random_acceleration_exit_time(0.5 + y / 2, 2, 0.5);
    std::vector<double> errors;
    for (const int n : {24, 36, 54}) {
      errors.push_back(values_from(problem, strip, y, 0, n, 3 * n / 2 + 3 * n / 2 % 2).mean_time -
                       exact);
    }
    EXPECT_LT(std::abs(errors[2]), 2e-5 * exact) << y;
    for (const int k : {0, 1}) {
      const double order = std::log(errors[k] / errors[k + 1]) / std::log(1.5);
      EXPECT_GT(order, 2.3) << y;
      EXPECT_LT(order, 6) << y;
    }
  }
}

// The probability of the upper end is I_X(1/6, 1/6) (Bicout and Burkhardt, J. Phys. A 33, 6835
// (2000)).
TEST(BarrierGrid, HasTheExactValuesBetweenTwoBarriers) {
  const double lower = -0.7, length = 2.5;
  const PassageStrip strip{LowerEnd::barrier, lower, lower + length, 8};
  for (const double part : {0.25, 0.5, 0.9}) {
    const Values found =
        values_from(random_acceleration(1), strip, lower + part * length, 0, 36, 54);
    const double exact = exact::random_acceleration_exit_time(part, length, 0.5);
    EXPECT_NEAR(found.mean_time, exact, 3e-4 * exact) << part;
    EXPECT_NEAR(found.upper_exit, boost::math::ibeta(1. / 6, 1. / 6, part), 5e-5) << part;
  }
}

// The exponent of T at (0, 0) depends on the restitution coefficient.
TEST(BarrierGrid, ConvergesBehindAnInelasticWall) {
  const PassageStrip strip{LowerEnd::wall, 0, 1, 6};
  const problem::Problem problem = random_acceleration(0.5);
  const double finest = values_from(problem, strip, 0, 0, 80, 120).mean_time;
  const double coarse = values_from(problem, strip, 0, 0, 24, 36).mean_time - finest;
  const double fine = values_from(problem, strip, 0, 0, 36, 54).mean_time - finest;
  EXPECT_LT(std::abs(fine), 2e-4 * finest);
  EXPECT_GT(std::abs(coarse / fine), std::pow(1.5, 1.5));
}

// The mean time in which a ball under gravity g and noise 2D returns to 0 from (0, v0), in units of
// V = 2D/g and V/g: v0 + int a K(a, v0) da with the kernel K of McKean (exact/inelastic_ball.hpp).
// The ball reaches the upper barrier with a probability below 3e-6.
TEST(BarrierGrid, HasTheMeanTimeOfFirstReturnOfTheBall) {
  const PassageStrip strip{LowerEnd::barrier, 0, 80, 14};
  const problem::Problem problem =
      tests::with_noise(System({.damping = 0, .constant = 1, .stiffness = 0}, {.none = true}), 1);
  const std::pair<double, double> exact[] = {{0.5, 1.576239}, {1, 2.633170}, {2, 4.659963}};
  for (const auto& [v0, mean] : exact) {
    EXPECT_NEAR(values_from(problem, strip, 0, v0, 80, 120).mean_time, mean, 1e-3 * mean) << v0;
  }
}

// Without excitation a ball between two barriers leaves the strip at the upper barrier from states
// above the orbit that grazes this barrier. The mean time jumps across the orbit; the order of its
// L1 error is therefore 1, and not that of the differences.
TEST(BarrierGrid, ConvergesWithOrderOneWithoutNoise) {
  const problem::Problem problem =
      tests::with_noise(System({.damping = 0, .constant = 1, .stiffness = 0}, {.none = true}), 1);
  constexpr double kSlowest = 2;  // largest speed of a start; faster states leave the grid in v
  const auto l1_error = [&](int n) {
    const BarrierGrid grid(problem, {}, {LowerEnd::barrier, 0, 1, 4}, n, 3 * n / 2);
    const Eigen::SparseLU<SparseColumnMatrix> lu(grid.backward_system().matrix);
    const Eigen::VectorXd times = lu.solve(Eigen::VectorXd::Constant(grid.size(), -1)),
                          weights = grid.integration_weights();
    double error = 0;
    for (int i = 0; i < grid.displacement_count(); ++i) {
      for (int j = 0; j < grid.velocity_count(); ++j) {
        const double y = grid.displacement(i), v = grid.velocity(j);
        if (std::abs(v) > kSlowest) continue;
        const double above = v * v - 2 * (1 - y);  // twice the energy above the barrier
        const double exact =
            v > 0 && above > 0 ? v - std::sqrt(above) : v + std::sqrt(v * v + 2 * y);
        const int node = grid.grid_node_index(i, j);
        error += weights(node) * std::abs(times(node) - exact);
      }
    }
    return error;
  };
  const double order = std::log(l1_error(20) / l1_error(80)) / std::log(4);
  EXPECT_GT(order, 0.7);
  EXPECT_LT(order, 1.4);
}

// A problem with all terms, whose wall has a restitution coefficient that depends on the speed.
problem::Problem problem_with_all_terms() {
  std::istringstream ini(R"([system]
force = 0.2*v + y + 0.3*y*v
[wall]
left = 0
left_restitution = 0.9 - 0.2*min(1, abs(v))
[impulse]
rate = 1.3
law = gamma
skewness = 1
mean = 0.2
intensity = 0.3
[noise]
intensity = 0.4
factor = 1 + 0.2*y + 0.1*v
interpretation = ito
)");
  return problem::read_case(ini, "test", "test.ini");
}

Eigen::VectorXd values_on_nodes(const BarrierGrid& grid,
                                const std::function<double(double y, double v)>& f) {
  Eigen::VectorXd values(grid.size());
  for (int i = 0; i < grid.displacement_count(); ++i) {
    for (int j = 0; j < grid.velocity_count(); ++j) {
      values(grid.grid_node_index(i, j)) = f(grid.displacement(i), grid.velocity(j));
    }
  }
  return values;
}

// The function 1 is the probability to leave the strip at all.
TEST(BarrierGrid, ConservesProbabilityExceptAtTheBarrier) {
  const problem::Problem problem = problem_with_all_terms();
  const auto excitation = BackwardEquationExcitation::of_equation(problem, DensityEquation::kf);
  for (const LowerEnd end : {LowerEnd::wall, LowerEnd::box}) {
    const BarrierGrid grid(problem, excitation, {end, 0, 1.5, 3}, 12, 20);
    const auto [matrix, upper_exit_terms] = grid.backward_system();
    const Eigen::VectorXd rest = matrix * Eigen::VectorXd::Ones(grid.size()) + upper_exit_terms;
    EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-9 * matrix.coeffs().cwiseAbs().maxCoeff());
  }
}

TEST(BarrierGrid, HasTheBackwardOperatorOfSmoothFunctions) {
  const problem::Problem problem = problem_with_all_terms();
  const auto& law = problem.impulses.amplitude_law();
  const double rate = problem.impulses.arrival_rate();
  for (const DensityEquation equation : {DensityEquation::kf, DensityEquation::white}) {
    const auto excitation = BackwardEquationExcitation::of_equation(problem, equation);
    const BarrierGrid grid(problem, excitation, {LowerEnd::wall, 0, 1.5, 6}, 40, 120);
    const SparseColumnMatrix matrix = grid.backward_system().matrix;
    const Eigen::VectorXd of_y = matrix * values_on_nodes(grid, [](double y, double) { return y; });
    const Eigen::VectorXd of_v = matrix * values_on_nodes(grid, [](double, double v) { return v; });
    const Eigen::VectorXd of_square =
        matrix * values_on_nodes(grid, [](double, double v) { return v * v; });
    for (int i = 5; i < grid.displacement_count() - 5; ++i) {
      const double y = grid.displacement(i);
      for (int j = 0; j < grid.velocity_count(); ++j) {
        const double v = grid.velocity(j), force = problem.system.force(y, v);
        if (std::abs(v) > 1.5) continue;  // impulses from larger speeds leave the grid
        const int node = grid.grid_node_index(i, j);
        EXPECT_NEAR(of_y(node), v, 1e-3);
        const double drift = rate * law.mean() - force;
        EXPECT_NEAR(of_v(node), drift, 1e-4);
        const double diffusion = 0.2 * std::pow(1 + 0.2 * y + 0.1 * v, 2);
        const double second = rate * law.moment(2);
        EXPECT_NEAR(of_square(node), 2 * v * drift + 2 * diffusion + second, 1e-3);
      }
    }
  }
}

TEST(BarrierGrid, InterpolatesAndIntegratesSmoothFunctions) {
  const problem::Problem problem = problem_with_all_terms();
  const auto excitation = BackwardEquationExcitation::of_equation(problem, DensityEquation::kf);
  const BarrierGrid grid(problem, excitation, {LowerEnd::wall, 0, 1.5, 6}, 40, 80);
  const auto f = [](double y, double v) { return std::cos(y + 0.5) * std::exp(-v * v - v / 2); };
  const Eigen::VectorXd values = values_on_nodes(grid, f);
  EXPECT_NEAR(grid.interpolation_weights_at_state(0.6, -0.4).dot(values), f(0.6, -0.4), 1e-5);
  EXPECT_NEAR(grid.interpolation_weights_at_state(1.5, -0.4).dot(values), f(1.5, -0.4), 1e-5);
  EXPECT_NEAR(grid.interpolation_weights_at_state(0, 0.4).dot(values), f(0, 0.4), 1e-5);
  // The restitution coefficient is 0.8 at the impact speed 0.5.
  EXPECT_NEAR(grid.interpolation_weights_at_state(0, -0.5).dot(values), f(0, 0.4), 1e-5);
  const double exact =
      (std::sin(2) - std::sin(0.5)) * std::sqrt(std::numbers::pi) * std::exp(1. / 16);
  EXPECT_NEAR(grid.integration_weights().dot(values), exact, 1e-5);
}

// E exp(a Y) of Gaussian amplitudes, away from the wall
TEST(BarrierGrid, HasTheMeanAfterAnImpulse) {
  const problem::Problem problem =
      tests::with_impulses(System({.damping = 0.1, .stiffness = 1}, {.none = true}),
                           tests::gaussian_impulses(2, 0.4, 0.1));
  const auto excitation = BackwardEquationExcitation::of_equation(problem, DensityEquation::kf);
  const BarrierGrid grid(problem, excitation, {LowerEnd::barrier, -1, 1.5, 6}, 12, 80);
  const Eigen::VectorXd values =
      values_on_nodes(grid, [](double, double v) { return std::exp(0.7 * v); });
  const double variance = 0.4 / 2 - 0.1 * 0.1;
  EXPECT_NEAR(grid.mean_after_impulse_weights(0.2).dot(values),
              std::exp(0.7 * 0.1 + 0.49 * variance / 2), 1e-4);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
