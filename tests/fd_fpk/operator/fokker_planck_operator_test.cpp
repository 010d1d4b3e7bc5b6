#include "fd_fpk/operator/fokker_planck_operator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "general_oscillators.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "paper_cases.hpp"
#include "problem/balances.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::ImpactCondition;

// Cell averages of a function by 3 x 3 Gauss points per cell, the unknowns of the operator.
template <class Function>
Eigen::VectorXd three_point_averages(const PhasePlaneGrid& grid, const Function& f) {
  Eigen::VectorXd averages(grid.size());
  const auto& x1 = grid.x1.faces();
  const auto& x2 = grid.x2.faces();
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      const auto of_x2 = [&](double x) {
        return numerics::gauss_legendre_average([&](double v) { return f(x, v); }, x2[j],
                                                x2[j + 1]);
      };
      averages(i * grid.v_cell_count() + j) =
          numerics::gauss_legendre_average(of_x2, x1[i], x1[i + 1]);
    }
  }
  return averages;
}

TEST(Operator, ColumnsSumToZeroForEveryExcitationOrderAndRestitution) {
  for (const double r : {1.0, 0.98, 0.4}) {
    const auto p = tests::make_problem({.restitution = r, .mean = 0.1});
    const PhasePlaneGrid grid = make_grid(20, 30, 3.0, 3.0, {0.5, 0.2}, {0.5, 0.3});
    for (const int order : {3, 4, 5, 6}) {
      for (const DiscretisedExcitation& e :
           {white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, grid.x2, 0.4),
            kramers_moyal_pade_excitation(p.impulses, grid.x2, 6),
            jump_excitation(p.impulses, grid.x2)}) {
        for (const ImpactCondition impact : {ImpactCondition::map, ImpactCondition::delta}) {
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
    const PhasePlaneGrid grid = make_grid(cells, 2 * cells, 4.5, 5.0);
    const auto op = fokker_planck_operator(p.system, white_noise_excitation(p.impulses),
                                           ImpactCondition::map, grid, order);
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
    const PhasePlaneGrid grid = make_grid(60, 2 * 50, 5.0, 9.0);
    const auto density = [](double x, double v) {
      return std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * (v + 0.3) * (v + 0.3) + 0.3 * x * v);
    };
    Eigen::VectorXd averages = three_point_averages(grid, density);
    averages /= grid.cell_areas().dot(averages);
    const int order = 5;
    for (const DiscretisedExcitation& e :
         {white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, grid.x2, 0.4),
          kramers_moyal_pade_excitation(p.impulses, grid.x2, 6),
          jump_excitation(p.impulses, grid.x2)}) {
      const auto op = fokker_planck_operator(p.system, e, ImpactCondition::map, grid, order);
      const Eigen::VectorXd rate = op * averages;
      const double d_energy = mean_energy(problem::EffectivePotential(p.system), grid, rate, order);
      const transform::Moments m = moments(grid, averages, order);
      const double power = p.impulses.rate_times_moment(2) / 2 +
                           p.impulses.rate_times_moment(1) * m.v1 - p.system.damping() * m.v2 -
                           (1 - r * r) / 2 * wall_speed_moment(grid, averages, order, 3);
      EXPECT_NEAR(d_energy, power, 4e-4) << "r = " << r;
    }
  }
}

// The density on the wall jumps at x2 = 0 by 1/r^2: stencils must not mix velocities before and
// after the impact.
TEST(Operator, FluxIntoTheWallUsesVelocitiesTowardsItAlone) {
  const PhasePlaneGrid grid = make_grid(20, 30, 3.0, 3.0);
  const AxisOperator flux(wall_flux_matrix(grid, 5));
  for (int speed = 0; speed < flux.rows(); ++speed) {
    for (AxisOperator::InnerIterator entry(flux, speed); entry; ++entry) {
      EXPECT_LT(entry.col() % grid.v_cell_count(), grid.v_cell_count() / 2);
    }
  }
  // Particles near x1 = 0.1 with velocity -1.1: a flux u p at speed u = 1.1, none elsewhere.
  Eigen::VectorXd beam = Eigen::VectorXd::Zero(grid.size());
  for (int i = 0; i < grid.nx(); ++i) beam(i * grid.v_cell_count() + 9) = 1;  // -1.2 < x2 < -1.0
  const Eigen::VectorXd out = flux * beam;
  EXPECT_NEAR(out.sum(), 1.1, 1e-2);
  EXPECT_NEAR(out(5), 1.1, 1e-2);
}

// Average over a density that is not normalised.
template <class Density, class Function>
double mean(const PhasePlaneGrid& grid, const Density& density, const Function& g) {
  return three_point_averages(grid, [&](double x, double v) { return g(x, v) * density(x, v); })
             .sum() /
         three_point_averages(grid, density).sum();
}

TEST(Operator, MovesTheMeanVelocityByDampingForceImpulsesAndImpacts) {
  // d/dt E[v] = -c E[v] - E[g(x)] + lambda E[Y] + (1+r) int_{v<0} v^2 p(0,v) dv
  const auto p = tests::make_problem({.cubic = 0.4, .restitution = 0.7, .mean = 0.12});
  const PhasePlaneGrid grid = make_grid(60, 128, 5.0, 5.5);
  const auto density = [](double x, double v) {
    return std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * (v + 0.3) * (v + 0.3) + 0.3 * x * v);
  };
  Eigen::VectorXd averages = three_point_averages(grid, density);
  averages /= grid.cell_areas().dot(averages);
  const auto op = fokker_planck_operator(p.system, jump_excitation(p.impulses, grid.x2),
                                         ImpactCondition::map, grid, 5);
  const double force =
      mean(grid, density, [&](double x, double) { return p.system.restoring_force()(x); });
  EXPECT_NEAR(moments(grid, op * averages, 5).v1,
              -0.1 * moments(grid, averages, 5).v1 - force + p.impulses.rate_times_moment(1) +
                  1.7 * wall_speed_moment(grid, averages, 5, 2),
              1e-4);
}

TEST(Operator, MovesTheDisplacementByTheVelocity) {
  // d/dt E[x^2] = 2 E[x v], for a density that vanishes on the wall.
  const auto p = tests::make_problem();
  const PhasePlaneGrid grid = make_grid(60, 128, 5.0, 5.0);
  const auto density = [](double x, double v) {
    return x * x * std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * (v + 0.3) * (v + 0.3) + 0.3 * x * v);
  };
  Eigen::VectorXd averages = three_point_averages(grid, density);
  averages /= grid.cell_areas().dot(averages);
  const auto op = fokker_planck_operator(p.system, white_noise_excitation(p.impulses),
                                         ImpactCondition::map, grid, 5);
  EXPECT_NEAR(moments(grid, op * averages, 5).y2,
              2 * mean(grid, density, [](double x, double v) { return x * v; }), 1e-5);
}

using problem::Problem;
using problem::System;

struct Domain {
  const char* name;
  problem::WallParameters walls;
};
// In wall coordinates: the whole axis, a wall at 0, walls at 0 and 2.
const std::array kDomains{
    Domain{"none", {.none = true}}, Domain{"left", {.left = 0, .left_restitution = 0.7}},
    Domain{"two", {.left = 0, .left_restitution = 0.7, .right = 2, .right_restitution = 0.85}}};

// Every term of the equation, each of significant size.
Problem with_every_term(const problem::WallParameters& walls) {
  Problem p = tests::with_impulses(System({.damping = -0.2,
                                           .van_der_pol = 0.3,
                                           .rayleigh = 0.07,
                                           .constant = 0.3,
                                           .stiffness = -0.4,
                                           .quadratic = 0.1,
                                           .cubic = 0.25,
                                           .quintic = 0.02},
                                          walls),
                                   tests::gaussian_impulses(2, 0.3, 0.12));
  p.noise = {0.14};
  return p;
}

PhasePlaneGrid grid_of(const System& system, double left, double right, double v_max, int nx,
                       int nv) {
  if (system.left_wall()) left = system.left_wall()->position;
  if (system.right_wall()) right = system.right_wall()->position;
  std::vector<double> x1, x2;
  for (int f = 0; f <= nx; ++f) x1.push_back(left + f * (right - left) / nx);
  for (int f = 0; f <= nv / 2; ++f) x2.push_back(f * v_max / (nv / 2));
  return symmetric_grid(
      x1, x2, system.left_wall() ? AxisEndCondition::boundary : AxisEndCondition::vacuum,
      system.right_wall() ? AxisEndCondition::boundary : AxisEndCondition::vacuum);
}

std::vector<DiscretisedExcitation> excitations(const Problem& p, const PhasePlaneGrid& grid) {
  std::vector<DiscretisedExcitation> all{
      white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, grid.x2, 0.4),
      kramers_moyal_pade_excitation(p.impulses, grid.x2, 6), jump_excitation(p.impulses, grid.x2)};
  for (DiscretisedExcitation& e : all) e.diffusion += p.noise.diffusion();
  return all;
}

// No net flux into the walls at 0 and 2: a flux would appear in the cells at the wall, at a
// different potential.
double bump(double x, double v) {
  const double skew = 0.8 * v * x * (2 - x) * std::exp(-x * x - 0.5 * v * v);
  return std::exp(-(x - 0.4) * (x - 0.4) - 0.8 * v * v) * (1 + skew);
}

TEST(OperatorOfGeneralOscillator, KeepsTheMassOnEveryDomain) {
  for (const auto& [name, walls] : kDomains) {
    const Problem p = with_every_term(walls);
    const PhasePlaneGrid grid = grid_of(p.system, -3, 3, 3, 20, 30);
    for (const int order : {3, 4, 5, 7}) {
      for (const DiscretisedExcitation& e : excitations(p, grid)) {
        const auto op = fokker_planck_operator(p.system, e, ImpactCondition::map, grid, order);
        EXPECT_LT(op.max_mass_loss_rate(), 1e-10) << name << " " << order;
      }
    }
  }
}

// d/dt of the energy of any density by the operator, against input minus dissipation: any wrong
// sign or factor of damping, force, noise or losses at a wall causes a large difference.
TEST(OperatorOfGeneralOscillator, ChangesTheEnergyOfAnyDensityAtTheExactPower) {
  for (const auto& [name, walls] : kDomains) {
    const Problem p = with_every_term(walls);
    const PhasePlaneGrid grid =
        grid_of(p.system, -4.6, 5.4, 8, p.system.right_wall() ? 24 : 80, 120);
    Eigen::VectorXd averages = three_point_averages(grid, bump);
    averages /= grid.cell_areas().dot(averages);
    for (const DiscretisedExcitation& e : excitations(p, grid)) {
      const auto op = fokker_planck_operator(p.system, e, ImpactCondition::map, grid, 5);
      const double rate =
          mean_energy(problem::EffectivePotential(p.system), grid, op * averages, 5);
      const auto [input, dissipated] = problem::power_balance(
          p, power_balance_terms(p, ImpactCondition::map, moments(grid, averages, 5), grid,
                                 averages, 5));
      EXPECT_GT(std::abs(dissipated), 0.05);
      EXPECT_NEAR(rate, input - dissipated, 5e-4) << name;
    }
  }
}

// d/dt E[v]: the terms of the momentum balance. For a nonstationary density its sides differ by
// d/dt E[v] and the damping -E[c(x) v].
TEST(OperatorOfGeneralOscillator, MovesTheMeanVelocityByForcesImpulsesAndImpacts) {
  for (const auto& [name, walls] : kDomains) {
    const Problem p = with_every_term(walls);
    const PhasePlaneGrid grid =
        grid_of(p.system, -4.6, 5.4, 8, p.system.right_wall() ? 24 : 80, 120);
    Eigen::VectorXd averages = three_point_averages(grid, bump);
    averages /= grid.cell_areas().dot(averages);
    const auto mean = [&](const auto& g) {
      return grid.cell_areas().dot(three_point_averages(grid, [&](double x, double v) {
        return g(x, v) * bump(x, v);
      })) / grid.cell_areas().dot(three_point_averages(grid, bump));
    };
    const auto& system = p.system;
    double expected = -mean([&](double x, double v) {
      return system.restoring_force()(x) + system.damping_polynomial()(x) * v +
             system.rayleigh_coefficient() * v * v * v;
    }) + p.impulses.rate_times_moment(1);
    if (system.left_wall()) expected += 1.7 * wall_speed_moment(grid, averages, 5, 2);
    if (system.right_wall())
      expected -= 1.85 * wall_speed_moment(grid, averages, 5, 2, AxisEnd::right);
    const auto op =
        fokker_planck_operator(system, excitations(p, grid).back(), ImpactCondition::map, grid, 5);
    EXPECT_NEAR(moments(grid, op * averages, 5).v1, expected, 3e-4) << name;
  }
}

TEST(OperatorOfGeneralOscillator, FluxIntoTheRightWallUsesPositiveVelocitiesAlone) {
  const System system({.stiffness = 1}, kDomains[2].walls);
  const PhasePlaneGrid grid = grid_of(system, 0, 2, 3, 20, 30);
  const AxisOperator flux(wall_flux_matrix(grid, 5, AxisEnd::right));
  for (int speed = 0; speed < flux.rows(); ++speed) {
    for (AxisOperator::InnerIterator entry(flux, speed); entry; ++entry) {
      EXPECT_GE(entry.col() % grid.v_cell_count(), grid.v_cell_count() / 2);
      EXPECT_GE(entry.col() / grid.v_cell_count(), 15);  // the five cells at the wall
    }
  }
  Eigen::VectorXd beam = Eigen::VectorXd::Zero(grid.size());
  for (int i = 0; i < grid.nx(); ++i) beam(i * grid.v_cell_count() + 20) = 1;  // 1.0 < x2 < 1.2
  const Eigen::VectorXd out = flux * beam;
  EXPECT_NEAR(out.sum(), 1.1, 1e-2);
  EXPECT_NEAR(out(5), 1.1, 1e-2);
}

TEST(OperatorOfGeneralOscillator, AnnihilatesExactDensitiesToItsOrder) {
  struct Case {
    std::string name;
    Problem problem;
    double left, right, v_max;
  };
  const auto well = [](const problem::WallParameters& walls) {
    return tests::with_noise(
        System({.damping = 0.4, .constant = 0.1, .stiffness = -0.5, .cubic = 0.5}, walls), 0.4);
  };
  const std::vector<Case> cases{
      {"well", well({.none = true}), -4, 4, 5},
      {"wall", well({.left = 0, .left_restitution = 1}), 0, 4, 5},
      {"walls", well({.left = 0, .left_restitution = 1, .right = 1.5, .right_restitution = 1}), 0,
       1.5, 5},
      {"ring",
       tests::with_noise(
           System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}),
           0.8),
       -2.9, 2.9, 2.9}};
  for (const Case& one : cases) {
    const Problem& p = one.problem;
    const exact::EnergyLaw law(p);
    const auto residual = [&](int cells, int order) {
      const PhasePlaneGrid grid =
          grid_of(p.system, one.left, one.right, one.v_max, cells, 2 * (7 * cells / 8));
      DiscretisedExcitation noise{.diffusion = p.noise.diffusion(), .exchange = {}};
      const auto op = fokker_planck_operator(p.system, noise, ImpactCondition::map, grid, order);
      return grid.cell_areas().dot((op * three_point_averages(grid, law)).cwiseAbs());
    };
    for (const int order : {3, 5}) {
      const double coarse = residual(40, order), middle = residual(56, order),
                   fine = residual(80, order);
      for (const double observed : {std::log(coarse / middle) / std::log(1.4),
                                    std::log(middle / fine) / std::log(10 / 7.)}) {
        EXPECT_GT(observed, order - 0.6)
            << one.name << ": " << coarse << " " << middle << " " << fine;
        EXPECT_LT(observed, order + 1.2)
            << one.name << ": " << coarse << " " << middle << " " << fine;
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
