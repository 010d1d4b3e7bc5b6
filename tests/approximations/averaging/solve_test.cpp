#include "approximations/averaging/solve.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "approximations/averaging/band_probabilities.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "fd_fpk/solve.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::averaging {
namespace {

using problem::DensityEquation;
using problem::System;
using transform::Status;

const problem::WallParameters kNoWall{.none = true};

transform::Solution solve_ok(const problem::Problem& problem, DensityEquation equation) {
  auto solution =
      solve_averaged_equation(tests::in_wall_coordinates(problem), {.equation = equation});
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  return solution;
}

// With damping c y' and no losses at walls, the exact density depends on the energy alone.
TEST(Averaging, IsExactForWhiteNoiseWithoutImpactLosses) {
  const System systems[] = {
      System({.damping = 0.2, .stiffness = 1, .cubic = 0.5}, kNoWall),
      System({.damping = 0.2, .constant = 0.1, .stiffness = -1, .cubic = 1}, kNoWall),
      System({.damping = 0.2, .stiffness = 1},
             {.left = -0.5, .left_restitution = 1, .right = 0.7, .right_restitution = 1})};
  for (const auto& system : systems) {
    const auto problem = tests::with_noise(system, 0.1);
    const exact::EnergyLaw law(problem);
    constexpr double kTolerance = 1e-3;
    for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
      const auto moments = solve_ok(problem, equation).moments;
      EXPECT_NEAR(moments.y2, law.moment(2, 0), kTolerance * law.moment(2, 0));
      EXPECT_NEAR(moments.v2, law.moment(0, 2), kTolerance * law.moment(0, 2));
      EXPECT_NEAR(moments.v4, law.moment(0, 4), kTolerance * law.moment(0, 4));
    }
  }
}

// Noise alone, in the equation with jumps: an asymmetric potential with two wells.
TEST(Averaging, HasTheBandProbabilitiesOfWhiteNoise) {
  const auto problem = tests::in_wall_coordinates(tests::with_noise(
      System({.damping = 0.2, .constant = 0.1, .stiffness = -1, .cubic = 1}, kNoWall), 0.1));
  const auto averaging = std::make_shared<const problem::EnergyAveraging>(problem, 300);
  const auto probabilities = stationary_band_probabilities(problem, EnergyLevels(averaging));
  for (std::size_t b = 0; b < probabilities.size(); ++b) {
    EXPECT_NEAR(probabilities[b], averaging->energy_bands()[b].mass, 2e-3) << b;
  }
}

// E[v^2] of the linear oscillator follows from the balance of power alone. Its fourth moment is
// that of the exact law in the limit of weak damping: the distance to the exact moment is of the
// first order in c, if the rate of impulses is proportional to c.
TEST(Averaging, ConvergesToTheExactMomentsOfImpulsesAsDampingVanishes) {
  for (const double c : {0.1, 0.05, 0.025}) {
    const auto problem = tests::with_impulses(System({.damping = c, .stiffness = 1}, kNoWall),
                                              tests::gaussian_impulses(4 * c, 0.4 * c));
    const auto moments = solve_ok(problem, DensityEquation::kf).moments;
    const double v2 = exact::linear_cumulant(problem, 0, 2);
    const double v4 = exact::linear_cumulant(problem, 0, 4) + 3 * v2 * v2;
    EXPECT_NEAR(moments.v2, v2, 5e-3 * v2) << c;
    EXPECT_NEAR(moments.v4, v4, (1e-2 + 1 * c) * v4) << c;
  }
}

// The correction of the first order in c is an odd function of the velocity. The L1 error of p(y')
// is therefore of the first order, and the L1 error of p(y) of the second order.
TEST(Averaging, ErrorVanishesWithTheDamping) {
  const auto l1_errors = [](double c) {
    const auto problem = tests::in_wall_coordinates(tests::with_noise(
        System({.force = fmt::format("{} * y^2 * v + y", c), .restitution = 1}), c));
    const auto averaged = solve_ok(problem, DensityEquation::white);
    const auto exact = fd_fpk::solve_stationary_density(
                           problem, {.equation = DensityEquation::white, .accuracy = 1e-4})
                           .solution;
    EXPECT_EQ(exact.status, Status::ok) << exact.reason;
    std::vector<double> edges;
    for (int k = -100; k <= 100; ++k) edges.push_back(0.06 * k);
    const std::vector<double> y_edges(edges.begin() + 100, edges.end());
    const auto distance = [&](transform::StateVariable variable, const auto& bins) {
      return transform::l1_distance(transform::marginal(*averaged.density, variable, bins),
                                    transform::marginal(*exact.density, variable, bins));
    };
    return std::pair{distance(transform::StateVariable::y, y_edges),
                     distance(transform::StateVariable::ydot, edges)};
  };
  auto coarse = l1_errors(0.2);
  for (const double c : {0.1, 0.05}) {
    const auto fine = l1_errors(c);
    EXPECT_NEAR(std::log2(coarse.first / fine.first), 2, 0.1) << c;
    EXPECT_NEAR(std::log2(coarse.second / fine.second), 1, 0.1) << c;
    coarse = fine;
  }
}

TEST(Averaging, BalancesThePowerOfImpacts) {
  const auto problem = tests::make_problem({.restitution = 0.9, .rate = 4});
  EXPECT_NEAR(solve_ok(problem, DensityEquation::white).energy_residual, 0, 1e-4);
  EXPECT_NEAR(solve_ok(problem, DensityEquation::kf).energy_residual, 0, 2e-3);
}

TEST(Averaging, DoesNotSupportRestInContact) {
  const auto problem = tests::in_wall_coordinates(tests::with_impulses(
      System({.damping = 0.1, .constant = 1, .restitution = 0.9}), tests::gaussian_impulses(1, 1)));
  EXPECT_NE(unsupported_reason(problem, {}), "");
}

}  // namespace
}  // namespace fpkcheck::averaging
