#include "fd_fpk/operator/impact_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "general_oscillators.hpp"
#include "problem/motion_scales.hpp"
#include "thorough.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::Problem;
using problem::System;

struct Rates {
  double stated;  ///< impact_rate()
  double flux;    ///< flux of the extrapolation to the walls
};

Rates rates(const Problem& given, ImpactCondition impact, double origin_refinement,
            double refinement = 0.7) {
  const Problem p = tests::in_wall_coordinates(given);
  const FiniteVolumeOptions options{
      .impact = impact, .refinement = refinement, .origin_refinement = origin_refinement};
  const auto scales = problem::motion_scales(p);
  const PlaneDiscretisation on =
      discretise_density_equation(p, options, initial_box(p, scales, options));
  const auto op = fokker_planck_operator(p, options, on);
  Preconditioner preconditioner(p, on.excitation, impact, on.grid);
  const auto found =
      find_null_vector(op, preconditioner, initial_gaussian(on.grid, scales)).averages;
  if (!found) return {NAN, NAN};
  const int order = transport_order(options);
  return {
      .stated = impact_rate(p.system, on.excitation, impact, on.grid, *found, op * *found, order),
      .flux = flux_into_walls(p.system, on.grid, *found, order)};
}

// Losses, forces at the walls, impulses beside noise, damping dependent on y and y'.
Problem of_everything() {
  Problem p = tests::with_impulses(
      System({.damping = 0.1,
              .van_der_pol = 0.2,
              .rayleigh = 0.1,
              .constant = 0.4,
              .stiffness = 1,
              .cubic = 0.3},
             {.left = -0.3, .left_restitution = 0.85, .right = 1, .right_restitution = 0.9}),
      problem::ImpulseTrain({.arrival_rate = 2, .law = "laplace", .intensity = 0.3, .mean = 0.1}));
  p.noise = {0.2};
  return p;
}

// For small losses the flux into the wall converges fast enough to be a reference: with the power 2
// - beta of the cell width, which is 1.8 in this test.
TEST(ImpactRate, IsTheLimitOfTheFluxIntoTheWalls) {
  for (const ImpactCondition impact : {ImpactCondition::map, ImpactCondition::delta}) {
    if (impact == ImpactCondition::delta && !tests::is_thorough()) continue;
    constexpr double kFine = 1.4;
    const Rates coarse = rates(of_everything(), impact, 12, kFine),
                fine = rates(of_everything(), impact, 48, kFine);
    EXPECT_NEAR(fine.flux / fine.stated, 1, 1e-5);
    EXPECT_NEAR(coarse.stated / fine.stated, 1, 5e-6);
    EXPECT_GT(std::abs(coarse.flux / fine.stated - 1), 5e-5);
  }
}

// In mirrored coordinates the walls are exchanged.
TEST(ImpactRate, DoesNotDependOnTheSideOfTheWall) {
  const System both(
      {.damping = 0.1, .stiffness = 1},
      {.left = -0.5, .left_restitution = 0.6, .right = 0.5, .right_restitution = 0.8});
  const System other(
      {.damping = 0.1, .stiffness = 1},
      {.left = -0.5, .left_restitution = 0.8, .right = 0.5, .right_restitution = 0.6});
  // An arbitrary nonstationary density and its mirror image.
  const auto rate = [](const System& system, bool mirrored) {
    const Problem p = tests::in_wall_coordinates(tests::with_noise(system, 0.2));
    const FiniteVolumeOptions options{.refinement = 0.7, .origin_refinement = 16};
    const auto scales = problem::motion_scales(p);
    const PlaneDiscretisation on =
        discretise_density_equation(p, options, initial_box(p, scales, options));
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(on.grid.size(), 0, 1).array().sin() + 0.3;
    Eigen::VectorXd averages = initial_gaussian(on.grid, scales).cwiseProduct(x);
    if (mirrored) {
      averages = initial_gaussian(on.grid, scales).cwiseProduct(Eigen::VectorXd(x.reverse()));
    }
    const auto op = fokker_planck_operator(p, options, on);
    return impact_rate(p.system, on.excitation, ImpactCondition::map, on.grid, averages,
                       op * averages, transport_order(options));
  };
  const double one = rate(both, false);
  EXPECT_GT(one, 0);
  EXPECT_NEAR(rate(other, true), one, 1e-8 * one);
}

// Without losses, or without noise, the rate is the flux.
TEST(ImpactRate, IsTheFluxWhereTheDensityIsBounded) {
  const System elastic({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 1});
  const auto under_noise = rates(tests::with_noise(elastic, 0.2), ImpactCondition::map, 1);
  EXPECT_EQ(under_noise.stated, under_noise.flux);
  const System losing({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 0.7});
  const auto under_impulses = rates(tests::with_impulses(losing, tests::gaussian_impulses(2, 0.2)),
                                    ImpactCondition::map, 16);
  EXPECT_EQ(under_impulses.stated, under_impulses.flux);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
