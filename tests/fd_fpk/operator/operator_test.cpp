#include "fd_fpk/operator/operator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/closed_forms.hpp"
#include "fd_fpk/operator/observables.hpp"
#include "operator/three_point_averages.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::Impact;

TEST(Operator, ColumnsSumToZeroForEveryExcitationOrderAndRestitution) {
  for (const double r : {1.0, 0.98, 0.4}) {
    const auto p = tests::make_problem({.restitution = r, .mean = 0.1});
    const Grid grid = make_grid(20, 30, 3.0, 3.0, {0.5, 0.2}, {0.5, 0.3});
    for (const int order : {3, 4, 5, 6}) {
      for (const Excitation& e :
           {white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, grid.x2, 0.4),
            kramers_moyal_pade_excitation(p.impulses, grid.x2, 6),
            jump_excitation(p.impulses, grid.x2)}) {
        for (const Impact impact : {Impact::map, Impact::delta}) {
          const auto op = fokker_planck_operator(p.system, e, impact, grid, order);
          EXPECT_LT(op.max_mass_loss_rate(), 1e-10) << r << " " << order;
          // max_mass_loss_rate() against the assembled matrix.
          const Eigen::RowVectorXd sums = grid.cell_areas().transpose() * op.assembled_matrix();
          EXPECT_LT(sums.cwiseAbs().maxCoeff(), 1e-10 * grid.cell_areas().maxCoeff());
        }
      }
    }
  }
}

TEST(Operator, AnnihilatesTheExactWhiteNoiseDensityToItsOrder) {
  const auto p = tests::make_problem({.cubic = 0.5, .restitution = 1});
  const exact::WhiteNoiseDensity exact(p);
  const auto residual = [&](int cells, int order) {
    const Grid grid = make_grid(cells, 2 * cells, 4.5, 5.0);
    const auto op = fokker_planck_operator(p.system, white_noise_excitation(p.impulses),
                                           Impact::map, grid, order);
    const auto averages =
        three_point_averages(grid, [&](double x, double v) { return 2 * exact(x, v); });
    return grid.cell_areas().dot((op * averages).cwiseAbs());
  };
  for (const int order : {3, 4, 5}) {
    const double coarse = residual(36, order), middle = residual(54, order),
                 fine = residual(81, order);
    for (const double observed :
         {std::log(coarse / middle) / std::log(1.5), std::log(middle / fine) / std::log(1.5)}) {
      // For odd orders the weights and the centred parts are one order more accurate: the observed
      // order may be slightly higher.
      EXPECT_GT(observed, order - 0.5) << order << ": " << coarse << " " << middle << " " << fine;
      EXPECT_LT(observed, order + 0.9) << order << ": " << coarse << " " << middle << " " << fine;
    }
  }
}

// d/dt E[v^2/2 + U(x)] of an arbitrary density by the operator, against the power of the exact
// equation: input - damping - losses at the impact. Any wrong sign or factor causes a large
// difference.
TEST(Operator, ChangesTheEnergyOfAnyDensityAtTheExactPower) {
  for (const double r : {1.0, 0.8, 0.5}) {
    const auto p = tests::make_problem(
        {.cubic = 0.4, .restitution = r, .rate = 2, .intensity = 0.3, .mean = 0.12});
    const Grid grid = make_grid(60, 2 * 50, 5.0, 9.0);
    const auto density = [](double x, double v) {
      return std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * (v + 0.3) * (v + 0.3) + 0.3 * x * v);
    };
    Eigen::VectorXd averages = three_point_averages(grid, density);
    averages /= grid.cell_areas().dot(averages);
    const int order = 5;
    for (const Excitation& e :
         {white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, grid.x2, 0.4),
          kramers_moyal_pade_excitation(p.impulses, grid.x2, 6),
          jump_excitation(p.impulses, grid.x2)}) {
      const auto op = fokker_planck_operator(p.system, e, Impact::map, grid, order);
      const Eigen::VectorXd rate = op * averages;
      const double d_energy = mean_energy(p.system, grid, rate, order);
      const transform::Moments m = moments(grid, averages, order);
      const double power = p.impulses.rate_times_moment(2) / 2 +
                           p.impulses.rate_times_moment(1) * m.v1 - p.system.damping() * m.v2 -
                           (1 - r * r) / 2 * impact_flux(grid, averages, order, 3);
      EXPECT_NEAR(d_energy, power, 4e-4) << "r = " << r;
    }
  }
}

// The density on the wall jumps at x2 = 0 by 1/r^2: stencils must not mix velocities before and
// after the impact.
TEST(Operator, FluxIntoTheWallUsesVelocitiesTowardsItAlone) {
  const Grid grid = make_grid(20, 30, 3.0, 3.0);
  const AxisOperator flux(wall_flux_matrix(grid, 5));
  for (int speed = 0; speed < flux.rows(); ++speed) {
    for (AxisOperator::InnerIterator entry(flux, speed); entry; ++entry) {
      EXPECT_LT(entry.col() % grid.nv(), grid.nv() / 2);
    }
  }
  // Particles near x1 = 0.1 with velocity -1.1: a flux u p at speed u = 1.1, none elsewhere.
  Eigen::VectorXd beam = Eigen::VectorXd::Zero(grid.size());
  for (int i = 0; i < grid.nx(); ++i) beam(i * grid.nv() + 9) = 1;  // -1.2 < x2 < -1.0
  const Eigen::VectorXd out = flux * beam;
  EXPECT_NEAR(out.sum(), 1.1, 1e-2);
  EXPECT_NEAR(out(5), 1.1, 1e-2);
}

// Average over a density that is not normalised.
template <class Density, class Function>
double mean(const Grid& grid, const Density& density, const Function& g) {
  return three_point_averages(grid, [&](double x, double v) { return g(x, v) * density(x, v); })
             .sum() /
         three_point_averages(grid, density).sum();
}

TEST(Operator, MovesTheMeanVelocityByDampingForceImpulsesAndImpacts) {
  // d/dt E[v] = -c E[v] - E[g(x)] + lambda E[Y] + (1+r) int_{v<0} v^2 p(0,v) dv
  const auto p = tests::make_problem({.cubic = 0.4, .restitution = 0.7, .mean = 0.12});
  const Grid grid = make_grid(60, 128, 5.0, 5.5);
  const auto density = [](double x, double v) {
    return std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * (v + 0.3) * (v + 0.3) + 0.3 * x * v);
  };
  Eigen::VectorXd averages = three_point_averages(grid, density);
  averages /= grid.cell_areas().dot(averages);
  const auto op =
      fokker_planck_operator(p.system, jump_excitation(p.impulses, grid.x2), Impact::map, grid, 5);
  const double force =
      mean(grid, density, [&](double x, double) { return p.system.restoring_force()(x); });
  EXPECT_NEAR(moments(grid, op * averages, 5).v1,
              -0.1 * moments(grid, averages, 5).v1 - force + p.impulses.rate_times_moment(1) +
                  1.7 * impact_flux(grid, averages, 5, 2),
              1e-4);
}

TEST(Operator, MovesTheDisplacementByTheVelocity) {
  // d/dt E[x^2] = 2 E[x v], for a density that vanishes on the wall.
  const auto p = tests::make_problem();
  const Grid grid = make_grid(60, 128, 5.0, 5.0);
  const auto density = [](double x, double v) {
    return x * x * std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * (v + 0.3) * (v + 0.3) + 0.3 * x * v);
  };
  Eigen::VectorXd averages = three_point_averages(grid, density);
  averages /= grid.cell_areas().dot(averages);
  const auto op =
      fokker_planck_operator(p.system, white_noise_excitation(p.impulses), Impact::map, grid, 5);
  EXPECT_NEAR(moments(grid, op * averages, 5).y2,
              2 * mean(grid, density, [](double x, double v) { return x * v; }), 1e-5);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
