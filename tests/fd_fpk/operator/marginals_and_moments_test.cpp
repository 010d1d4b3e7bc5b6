#include "fd_fpk/operator/marginals_and_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// E[|x|^n] of a normal variable, n even: (n - 1)!! s^n.
TEST(Observables, MomentsOfTheFoldedGaussianAreThoseOfTheNormalLaw) {
  const double s = 0.7, w = 0.9;
  const PhasePlaneGrid grid = make_grid(48, 96, 6 * s, 6.5 * w);
  const Eigen::VectorXd averages = gaussian_cell_averages({s, w}, grid);
  const auto m = moments(grid, averages, 5);
  EXPECT_NEAR(m.y1, s * std::sqrt(2 / M_PI), 1e-6);
  EXPECT_NEAR(m.y2, s * s, 1e-6);
  EXPECT_NEAR(m.y4, 3 * std::pow(s, 4), 1e-6);
  EXPECT_NEAR(m.v1, 0, 1e-12);
  EXPECT_NEAR(m.v2, w * w, 1e-6);
  EXPECT_NEAR(m.v4, 3 * std::pow(w, 4), 1e-6);
}

TEST(Observables, MeanEnergyIsKineticPlusTheMeanOfThePotential) {
  const double s = 0.7, w = 0.9;
  const PhasePlaneGrid grid = make_grid(48, 96, 6 * s, 6.5 * w);
  const Eigen::VectorXd averages = gaussian_cell_averages({s, w}, grid);
  for (const double cubic : {0.0, 0.4}) {
    const auto system = tests::make_problem({.cubic = cubic}).system;
    // U is even: its terms are moments of the normal law.
    double potential = 0, moment = s * s;
    for (std::size_t n = 2; n <= system.potential().degree(); n += 2) {
      potential += system.potential().coefficient(n) * moment;
      moment *= static_cast<double>(n + 1) * s * s;
    }
    EXPECT_NEAR(mean_energy(problem::EffectivePotential(system), grid, averages, 5),
                w * w / 2 + potential, 1e-6)
        << cubic;
  }
}

// int_{v<0} |v|^n p(0, v) dv of the folded Gaussian.
TEST(Observables, ImpactFluxIsThatOfTheOutgoingHalf) {
  const double s = 0.7, w = 0.9;
  const PhasePlaneGrid grid = make_grid(64, 128, 6 * s, 6.5 * w);
  const Eigen::VectorXd averages = gaussian_cell_averages({s, w}, grid);
  const double wall = 2 / (s * std::sqrt(2 * M_PI));
  EXPECT_NEAR(wall_speed_moment(grid, averages, 5, 1), wall * w / std::sqrt(2 * M_PI), 1e-5);
  EXPECT_NEAR(wall_speed_moment(grid, averages, 5, 3),
              wall * 2 * std::pow(w, 3) / std::sqrt(2 * M_PI), 1e-5);
}

// The folded Gaussian with w = sqrt(k) s is the density of a linear elastic oscillator under white
// noise.
TEST(Observables, BalancesOfVirialAndMomentumAreThoseOfTheFoldedGaussian) {
  const double k = 1.7, s = 0.7, w = std::sqrt(k) * s;
  const auto p = tests::make_problem({.stiffness = k, .cubic = 0, .restitution = 1});
  const PhasePlaneGrid grid = make_grid(64, 128, 6 * s, 6.5 * w);
  const auto of = [&](double velocity_deviation) {
    const auto averages = gaussian_cell_averages({s, velocity_deviation}, grid);
    return balance_residuals(p, grid, averages, 5,
                             wall_momentum_transfer(p.system, grid, averages, 5));
  };
  EXPECT_NEAR(*of(w).virial, 0, 1e-6);
  EXPECT_NEAR(*of(w).momentum, 0, 1e-5);
  // E[v^2] and the momentum at the wall are both proportional to the square of the deviation.
  EXPECT_NEAR(*of(1.1 * w).virial, 1 - 1 / 1.21, 1e-5);
  EXPECT_NEAR(*of(1.1 * w).momentum, 1 / 1.21 - 1, 1e-4);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
