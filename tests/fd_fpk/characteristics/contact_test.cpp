#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/characteristics/characteristic_grid.hpp"
#include "fd_fpk/characteristics/transport_operator.hpp"
#include "fd_fpk/solve.hpp"
#include "general_oscillators.hpp"
#include "problem/case_file.hpp"
#include "transform/coordinate_transformation.hpp"

// Motion that comes to rest in contact with a wall.
namespace fpkcheck::fd_fpk {
namespace {

using problem::Problem;
using problem::System;
using transform::Status;

FiniteVolumeResult solve_contact(const Problem& p, const FiniteVolumeOptions& options = {}) {
  const Problem seen = tests::in_wall_coordinates(p);
  EXPECT_EQ(unsupported_reason(seen, options), "");
  FiniteVolumeResult result = solve_stationary_density(seen, options);
  result.solution = transform::to_physical_coordinates(seen.frame, std::move(result.solution));
  return result;
}

Problem ball(double rate, double intensity, double restitution, const char* law = "gaussian",
             double mean = 0) {
  return tests::with_impulses(
      System({.damping = 0, .constant = 1, .restitution = restitution}),
      problem::ImpulseTrain(
          {.arrival_rate = rate, .law = law, .intensity = intensity, .mean = mean}));
}

void expect_identities(const FiniteVolumeResult& result, double bar = 1e-4) {
  EXPECT_LT(std::abs(result.solution.energy_residual), bar);
  EXPECT_LT(std::abs(*result.summary.balances.virial), bar);
  EXPECT_LT(std::abs(*result.summary.balances.momentum), bar);
}

// The time in flight is (2/g) (1 + r + ..) times the first speed, |Y| or r |Y|. So 1 - P0 is lambda
// E|Y| (1+r) / (g (1-r)), less the truncation by the next impulse, of second order in lambda.
TEST(Contact, TimeInFlightOfABallUnderRareImpulsesIsThatOfItsParabolas) {
  for (const double restitution : {0.3, 0.7}) {
    for (const double mean : {0.0, 0.5}) {
      const double rate = 1e-4;
      const auto p = ball(rate, rate, restitution, "uniform", mean);
      // E|Y| of the uniform law on mean +- h.
      const double h = std::sqrt(3) * p.impulses.amplitude_law().amplitude_standard_deviation();
      const double mean_size = (std::pow(h + mean, 2) + std::pow(h - mean, 2)) / (4 * h);
      // Off the wall at Y, into it at r |Y|: E[Y^+] + r E[Y^-] = (E|Y| (1+r) + E[Y] (1-r)) / 2.
      const double first = (mean_size * (1 + restitution) + mean * (1 - restitution)) / 2;
      const double aloft = rate * 2 * first / (1 - restitution);
      const auto solution = solve_contact(p).solution;
      ASSERT_EQ(solution.atoms.size(), 1u);
      EXPECT_NEAR((1 - solution.atoms[0].probability) / aloft, 1, 2e-3)
          << restitution << " " << mean;
      EXPECT_NEAR(solution.mass, 1, 1e-12);
    }
  }
}

// By `fpkcheck mcs NAME --time 1.5e8 --seed 5` (seed 6 where r is changed): values and standard
// errors.
TEST(Contact, ProbabilitiesOfRestOfShippedCasesAgreeWithTheSimulation) {
  struct Case {
    const char* name;
    std::vector<std::string> changes;
    std::vector<double> at_rest, errors;
  };
  const Case cases[] = {
      {"preload", {}, {0.010019}, {1.1e-5}},
      {"stops", {}, {0.012373, 0.012410}, {1.5e-5, 1.4e-5}},
      {"ball", {"system.restitution=0.5"}, {0.408009}, {4.2e-5}},
  };
  for (const auto& [name, changes, at_rest, errors] : cases) {
    const auto result = solve_contact(problem::load_case(name, changes));
    const auto& solution = result.solution;
    SCOPED_TRACE(name);
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    ASSERT_EQ(solution.atoms.size(), at_rest.size());
    for (std::size_t k = 0; k < at_rest.size(); ++k) {
      EXPECT_NEAR(solution.atoms[k].probability, at_rest[k], 4 * errors[k] + 2e-3 * at_rest[k]);
      ASSERT_TRUE(solution.atoms[k].error_estimate);
      EXPECT_LT(*solution.atoms[k].error_estimate, 0.01 * at_rest[k]);
    }
    expect_identities(result);
    EXPECT_GT(solution.min_density, -1e-4);
    EXPECT_NEAR(solution.mass, 1, 1e-10);
  }
}

// Refined by factors of 2: the differences of P0 decrease.
TEST(Contact, ProbabilityOfRestConverges) {
  std::vector<double> at_rest;
  for (const double refinement : {0.5, 1.0, 2.0}) {
    const auto p = tests::in_wall_coordinates(problem::load_case("preload"));
    at_rest.push_back(
        solve_stationary_density(p, {.refinement = refinement, .error_estimate = false})
            .solution.atoms.at(0)
            .probability);
  }
  const double before = std::abs(at_rest[1] - at_rest[0]), last = std::abs(at_rest[2] - at_rest[1]);
  EXPECT_LT(last, 2e-3 * at_rest[2]);
  EXPECT_GT(before / last, 1.5);
  EXPECT_LT(before / last, 12);
}

// The solution of the mirrored problem is the mirrored solution.
TEST(Contact, WallOnTheRightIsTheWallOnTheLeftMirrored) {
  const auto impulses =
      problem::ImpulseTrain({.arrival_rate = 0.8, .law = "laplace", .intensity = 0.4, .mean = 0.1});
  const auto mirrored = problem::ImpulseTrain(
      {.arrival_rate = 0.8, .law = "laplace", .intensity = 0.4, .mean = -0.1});
  const FiniteVolumeOptions once{.error_estimate = false};
  // Two mirror-image oscillators with g = y. The wall of the first is at 0.4, and the mass moves
  // right of the wall: the force on mass at rest is 0.4 towards the wall.
  const auto left = solve_contact(
      tests::with_impulses(
          System({.damping = 0.1, .stiffness = 1}, {.left = 0.4, .left_restitution = 0.6}),
          impulses),
      once);
  const auto right = solve_contact(
      tests::with_impulses(
          System({.damping = 0.1, .stiffness = 1}, {.right = -0.4, .right_restitution = 0.6}),
          mirrored),
      once);
  EXPECT_EQ(left.solution.atoms[0].y, 0.4);
  EXPECT_EQ(right.solution.atoms[0].y, -0.4);
  EXPECT_NEAR(left.solution.atoms[0].probability, right.solution.atoms[0].probability, 1e-12);
  EXPECT_NEAR(left.solution.moments.y1, -right.solution.moments.y1, 1e-12);
  EXPECT_NEAR(left.solution.moments.v4, right.solution.moments.v4, 1e-12);
  expect_identities(left, 5e-4);
}

// Walls without contact and an equilibrium: comparison with upwind differences, an independent
// discretisation.
TEST(Contact, WithoutContactAgreesWithDifferences) {
  for (const char* name : {"gap", "two_walls"}) {
    const auto p = problem::load_case(name);
    const auto along =
        solve_contact(p, {.transport = TransportScheme::characteristics, .error_estimate = false})
            .solution;
    const auto differences =
        solve_contact(p, {.transport = TransportScheme::upwind, .error_estimate = false}).solution;
    EXPECT_EQ(along.status, Status::ok) << along.reason;
    EXPECT_TRUE(along.atoms.empty());
    EXPECT_NEAR(along.moments.y2 / differences.moments.y2, 1, 5e-4);
    EXPECT_NEAR(along.moments.v4 / differences.moments.v4, 1, 5e-4);
    EXPECT_NEAR(along.moments.y1, differences.moments.y1, 2e-4);
  }
}

// The transport operator conserves the total mass, and loses the energy dissipated by damping and
// both walls (docs/characteristics.md).
TEST(Contact, TransportConservesMassAndLosesTheEnergyOfBothWalls) {
  const auto p = tests::in_wall_coordinates(problem::load_case("stops"));
  const PhasePlaneGrid grid =
      characteristic_grid(p, problem::motion_scales(p), {}, {.x1_max = 1, .x2_max = 3});
  const Characteristics characteristics(p.system, grid, p.impulses.arrival_rate(), 8);
  ASSERT_EQ(characteristics.indices_of_rest_points_in_contact().size(), 2u);
  const DensitySlopeReconstruction slopes(grid, characteristics.rest_points());
  Eigen::VectorXd q = Eigen::VectorXd::Zero(grid.size() + 2);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      const double y = grid.x1.cell_centre(i), v = grid.x2.cell_centre(j);
      q(i * grid.v_cell_count() + j) =
          std::exp(-2 * v * v) * (1 + y) * grid.x1.cell_width(i) * grid.x2.cell_width(j);
    }
  }
  q *= 0.7 / q.sum();
  q(grid.size()) = 0.2;
  q(grid.size() + 1) = 0.1;
  ImpactSumsOfBothWalls impacts;
  const TransportOperator passage(characteristics, p.impulses.amplitude_law());
  const Eigen::VectorXd after = passage(q, slopes(q), &impacts).ended;
  EXPECT_NEAR(after.sum(), 1, 1e-12);
  EXPECT_GT(after.minCoeff(), -1e-12);
  const auto energy = [&](const Eigen::VectorXd& masses, bool squares_alone) {
    double sum = 0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.v_cell_count(); ++j) {
        const double v = grid.x2.cell_centre(j);
        const double of_v = v * v + grid.x2.cell_width(j) * grid.x2.cell_width(j) / 12;
        sum += masses(i * grid.v_cell_count() + j) *
               (squares_alone ? of_v : of_v / 2 + p.system.potential()(grid.x1.cell_centre(i)));
      }
    }
    return sum;
  };
  // Impulses from rest add E[Y^2] / 2, and both walls are at the same potential.
  const double at_walls = p.system.potential()(0.0), rate = p.impulses.arrival_rate();
  const double before =
      energy(q, false) + 0.3 * (at_walls + p.impulses.amplitude_law().moment(2) / 2);
  const double then = energy(after, false) + after.tail(2).sum() * at_walls;
  const double r = p.system.restitution();
  const double lost = p.system.damping() * energy(after, true) +
                      (1 - r * r) / 2 * rate * (impacts.left.energy + impacts.right.energy);
  EXPECT_NEAR(rate * (before - then) / lost, 1, 2e-3);
}

TEST(Contact, IsRefusedForTransportsWithoutAtoms) {
  const auto p = tests::in_wall_coordinates(problem::load_case("preload"));
  EXPECT_NE(unsupported_reason(p, {.transport = TransportScheme::upwind}), "");
  EXPECT_NE(unsupported_reason(p, {.order = 3}), "");
  EXPECT_NE(unsupported_reason(p, {.nx = 40}), "");
  EXPECT_EQ(unsupported_reason(p, {.equation = DensityEquation::white}), "");
  EXPECT_NE(unsupported_reason(p, {.equation = DensityEquation::white,
                                   .transport = TransportScheme::characteristics}),
            "");
  const auto van_der_pol =
      tests::in_wall_coordinates(tests::with_impulses(System({.damping = -0.1,
                                                              .van_der_pol = 0.1,
                                                              .constant = 0.5,
                                                              .stiffness = 1,
                                                              .restitution = 0.7}),
                                                      tests::gaussian_impulses(1, 0.5)));
  EXPECT_NE(unsupported_reason(van_der_pol, {}).find("the damping of the problem"),
            std::string::npos);
  const auto walls = problem::WallParameters{
      .left = 0, .left_restitution = 0.7, .right = 1, .right_restitution = 0.7};
  const auto box =
      tests::with_impulses(System({.damping = 0}, walls), tests::gaussian_impulses(1, 0.5));
  EXPECT_NE(characteristics_unsupported_reason(box).find("no rest point"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
