#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/solve.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "general_oscillators.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

problem::System system_of(const std::string& formula,
                          const problem::WallParameters& walls = {.none = true}) {
  return problem::System({.force = formula}, walls);
}

// The term 0*abs(y) hides the polynomial from System.
TEST(Formula, HasTheOperatorOfItsPolynomial) {
  const problem::WallParameters walls{.left = 0, .left_restitution = 0.8};
  const problem::System polynomial({.damping = 0.1,
                                    .van_der_pol = 0.3,
                                    .rayleigh = 0.2,
                                    .constant = 0.4,
                                    .stiffness = 1,
                                    .quadratic = -0.3,
                                    .cubic = 0.5},
                                   walls);
  const problem::System formula =
      system_of("v*(0.1 + 0.3*y^2 + 0.2*v^2) + 0.4 + y - 0.3*y^2 + 0.5*y^3 + 0*abs(y)", walls);
  ASSERT_TRUE(polynomial.has_polynomial_force());
  ASSERT_FALSE(formula.has_polynomial_force());
  const PhasePlaneGrid grid = make_grid(14, 20, 2.5, 3.0, {0.5, 0.2}, {0.5, 0.3});
  const auto impulses = tests::gaussian_impulses(1, 0.5);
  for (const int order : {4, 5, 7}) {
    const auto assembled = [&](const problem::System& system) {
      return Eigen::MatrixXd(fokker_planck_operator(system, white_noise_excitation(impulses),
                                                    problem::ImpactCondition::map, grid, order)
                                 .assembled_matrix());
    };
    const Eigen::MatrixXd expected = assembled(polynomial);
    EXPECT_LT((assembled(formula) - expected).cwiseAbs().maxCoeff(),
              1e-11 * expected.cwiseAbs().maxCoeff())
        << order;
  }
}

// White noise and a damping that depends on the energy H = v^2/2 + V(y) alone: the exact density is
// C exp(-(1/D) int d(H) dH), here with d = 0.2 sqrt(1 + 2H) and V = cosh y - 1.
TEST(Formula, HasTheExactLawOfEnergyDependentDamping) {
  constexpr double kDiffusion = 0.1;
  const auto p = tests::with_noise(system_of("0.2*v*sqrt(1 + v^2 + 2*(cosh(y) - 1)) + sinh(y)"),
                                   2 * kDiffusion);
  const auto density = [](double y, double v) {
    const double energy = v * v / 2 + std::cosh(y) - 1;
    return std::exp(-0.2 / 3 * (std::pow(1 + 2 * energy, 1.5) - 1) / kDiffusion);
  };
  double mass = 0, y2 = 0, v2 = 0, v4 = 0;
  constexpr double kStep = 0.02;  // the trapezoidal rule converges exponentially
  for (double y = -5; y < 5; y += kStep) {
    for (double v = -6; v < 6; v += kStep) {
      const double w = density(y, v);
      mass += w;
      y2 += w * y * y;
      v2 += w * v * v;
      v4 += w * v * v * v * v;
    }
  }
  const auto [solution, summary] = solve_stationary_density(p, {});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_NEAR(solution.moments.y2, y2 / mass, 1e-6);
  EXPECT_NEAR(solution.moments.v2, v2 / mass, 1e-6);
  EXPECT_NEAR(solution.moments.v4, v4 / mass, 1e-5);
  EXPECT_LT(std::abs(solution.energy_residual), 1e-5);
}

// Impulses, no wall and damping 0.1 v: the balance of power is 0.1 E[v^2] = I/2.
TEST(Formula, KeepsTheBalanceOfPowerUnderImpulses) {
  const auto p = tests::with_impulses(system_of("0.1*v + tanh(2*y) + 0.2*y"),
                                      tests::gaussian_impulses(1, 0.2));
  const auto solution =
      solve_stationary_density(p, {.refinement = 0.7, .error_estimate = false}).solution;
  EXPECT_NEAR(solution.moments.v2, 1, 2e-4);
  EXPECT_LT(std::abs(solution.energy_residual), 2e-4);
}

TEST(Formula, HasFacesAtItsKinks) {
  const auto p = tests::with_impulses(system_of("0.1*v + y + 4*max(y - 0.5, 0) - 3*abs(y + 0.3)"),
                                      tests::gaussian_impulses(1, 0.2));
  const PhasePlaneBox box{.x1_max = 2, .x2_max = 3, .x1_min = -2, .lengths = {1, 1}};
  const auto faces = discretise_density_equation(p, {}, box).grid.x1.faces();
  for (const double kink : {-0.3, 0.5}) {
    double nearest = 1;
    for (const double face : faces) nearest = std::min(nearest, std::abs(face - kink));
    EXPECT_LT(nearest, 1e-12) << kink;
  }
}

// The spring is 9 times as stiff at y < 0, where the density is 3 times as narrow.
TEST(Formula, HasNarrowerCellsOnTheStiffSideOfAKink) {
  const auto p =
      tests::with_impulses(system_of("0.1*v + y - 8*max(-y, 0)"), tests::gaussian_impulses(1, 0.2));
  const PhasePlaneBox box{.x1_max = 4, .x2_max = 3, .x1_min = -4, .lengths = {1, 1}};
  const GridAxis x1 = discretise_density_equation(p, {}, box).grid.x1;
  EXPECT_NEAR(x1.cell_width(x1.cell_count() - 1) / x1.cell_width(0), 3, 0.1);
  for (int i = 0; i + 1 < x1.cell_count(); ++i) {
    EXPECT_LT(std::abs(std::log(x1.cell_width(i + 1) / x1.cell_width(i))), 0.25) << i;
  }
}

// Dry friction 0.3 between elastic walls under white noise: the law C exp(-(0.1 v^2 + 0.3 |v|)/D),
// uniform in y, has a kink at v = 0 (T. K. Caughey, J. K. Dienes, J. Appl. Phys. 32, 1961).
TEST(Formula, HasTheExactLawOfDryFrictionInABox) {
  constexpr double kDiffusion = 0.1, kLength = 2;
  const problem::WallParameters walls{
      .left = 0, .left_restitution = 1, .right = kLength, .right_restitution = 1};
  const auto p = tests::with_noise(system_of("0.2*v + 0.3*sign(v)", walls), 2 * kDiffusion);
  const auto law = [](double v) {
    return std::exp(-(0.1 * v * v + 0.3 * std::abs(v)) / kDiffusion);
  };
  const auto [solution, summary] = solve_stationary_density(p, {});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  const auto& [y, v, averages] = std::get<transform::GridDensity>(*solution.density);
  std::vector<double> masses;
  double total = 0;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) {
    double mass = 0;
    for (const auto& point : numerics::composite_gauss_points(v[j], v[j + 1], 1)) {
      mass += point.weight * law(point.at);
    }
    masses.push_back(mass);
    total += masses.back();
  }
  double l1 = 0;
  for (std::size_t i = 0; i + 1 < y.size(); ++i) {
    for (std::size_t j = 0; j < masses.size(); ++j) {
      const double area = (y[i + 1] - y[i]) * (v[j + 1] - v[j]);
      const double exact = masses[j] / total * (y[i + 1] - y[i]) / kLength;
      l1 += std::abs(area * averages[i * masses.size() + j] - exact);
    }
  }
  EXPECT_LT(l1, 1e-6);
  EXPECT_LT(std::abs(solution.energy_residual), 1e-6);
}

// Dry friction 0.2 under white noise of intensity 2 D = 0.2 has no known law of y. Exact are
// E|v| = D/0.2, the balance of power, and E[v^2] = E[y^2] + 0.2 E[y sign v], the virial.
TEST(Formula, KeepsTheBalancesOfDryFrictionUnderWhiteNoise) {
  const auto p = tests::with_noise(system_of("0.2*sign(v) + y"), 0.2);
  const auto [solution, summary] = solve_stationary_density(p, {});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_LT(std::abs(solution.energy_residual), 3e-5);
  EXPECT_LT(std::abs(*summary.balances.virial), 3e-5);
  // fpkcheck fd with --refinement 2 --origin-refinement 8
  EXPECT_NEAR(solution.moments.y2, 0.469358, 2 * summary.error->moments.y2);
  EXPECT_NEAR(solution.moments.v2, 0.465973, 2 * summary.error->moments.v2);
}

// Under impulses alone dry friction holds the mass at rest on an interval of y: the law has atoms.
TEST(Formula, MustNotJumpInVelocityWithoutNoiseOrElsewhereThanAtRest) {
  const auto impulses = tests::gaussian_impulses(1, 0.2);
  const auto reason = [&](const std::string& formula, const FiniteVolumeOptions& options = {}) {
    return unsupported_reason(tests::with_impulses(system_of(formula), impulses), options);
  };
  EXPECT_NE(reason("0.2*sign(v) + y").find("stick"), std::string::npos);
  EXPECT_NE(reason("0.1*v + 0.3*sign(v - 0.5) + y").find("stick"), std::string::npos);
  EXPECT_EQ(reason("0.1*v + 0.3*sign(y) + y"), "");
  EXPECT_EQ(reason("0.2*tanh(v/0.01) + y"), "");
  const FiniteVolumeOptions white{.equation = DensityEquation::white};
  EXPECT_EQ(reason("0.2*sign(v) + y", white), "");
  EXPECT_NE(reason("0.1*v + 0.3*sign(v - 0.5) + y", white).find("only at v = 0"),
            std::string::npos);
  EXPECT_NE(reason("0.1*v + 0.3*sign(v - y) + y", white).find("only at v = 0"), std::string::npos);
}

// Impulses of intensity I and rate 1, no wall: the balance of power is E[v f] = I/2. With the
// damping 0.1 v, E[v^2] = 1.
TEST(Formula, KeepsTheBalanceOfPowerWithKinksWithinItsError) {
  for (const char* formula : {"0.1*v + y + 4*max(y - 0.5, 0)", "0.1*v + y - 50*max(-y, 0)^1.5"}) {
    const auto p = tests::with_impulses(system_of(formula), tests::gaussian_impulses(1, 0.2));
    const auto [solution, summary] = solve_stationary_density(p, {});
    ASSERT_EQ(solution.status, Status::ok) << formula << ": " << solution.reason;
    EXPECT_NEAR(solution.moments.v2, 1, summary.error->moments.v2) << formula;
    EXPECT_LT(summary.error->moments.v2, 1e-4) << formula;
  }
  const auto p = tests::with_impulses(system_of("0.2*v*abs(v) + y + 0.1*y^3"),
                                      tests::gaussian_impulses(1, 0.5));
  const auto [solution, summary] = solve_stationary_density(p, {});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_LE(std::abs(solution.energy_residual),
            summary.error->moments.v2 / solution.moments.v2 * (1 + 1e-9));
  EXPECT_LT(std::abs(solution.energy_residual), 2e-5);
}

// The density at the lower end of y falls below the limit with the first move of this end, and
// rises above the limit again when the other ends move. A finer grid that moved the end would cost
// a second solution on each grid of the error estimate.
TEST(Formula, HasABoxThatAFinerGridDoesNotWiden) {
  const auto p = tests::with_impulses(system_of("0.1*v + y + 4*max(y - 0.5, 0)"),
                                      tests::gaussian_impulses(1, 0.2));
  const auto scales = problem::motion_scales(p);
  FiniteVolumeOptions options;
  options.order = kHighFiniteVolumeOrder;
  options.refinement = 0.6;
  options.wall_density *= box_edge_density_factor(p);
  const PhasePlaneBox box =
      stationary_box(p, scales, options, base::Deadline::without_time_limit());
  const DirectStationarySolution direct = compute_direct_solution(
      p, {.scales = scales, .box = box}, options, base::Deadline::without_time_limit());
  ASSERT_TRUE(direct.averages) << direct.failure;
  const PhasePlaneGrid& grid = direct.discretisation.grid;
  EXPECT_DOUBLE_EQ(grid.x1.faces().front(), box.x1_min);
  EXPECT_DOUBLE_EQ(grid.x1.faces().back(), box.x1_max);
  EXPECT_DOUBLE_EQ(grid.x2_max(), box.x2_max);
}

// The damping 0.02 v + 0.1 tanh(20 v) contracts areas near rest at the rate 2.02, above the impulse
// rate 1: the density is unbounded at the rest point at the wall, and only transport along
// characteristics resolves the density. The moments are those of
// `fpkcheck mcs --time 4e6 --seed 7`.
TEST(Formula, IsTransportedAlongCharacteristicsWhereTheDensityIsUnbounded) {
  const problem::WallParameters wall{.left = 0, .left_restitution = 0.9};
  const auto p = tests::with_impulses(system_of("0.02*v + 0.1*tanh(20*v) + y", wall),
                                      tests::gaussian_impulses(1, 0.5));
  const auto [solution, summary] = solve_stationary_density(p, {.max_seconds = 60});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_EQ(summary.transport, TransportScheme::characteristics);
  EXPECT_GE(solution.min_density, -1e-12);
  const auto& error = summary.error->moments;
  EXPECT_LE(std::abs(solution.energy_residual), error.v2 / solution.moments.v2 * (1 + 1e-9));
  EXPECT_LT(error.v2, 5e-3);
  EXPECT_NEAR(solution.moments.y2, 1.73126, error.y2 + 4 * 0.00075);
  EXPECT_NEAR(solution.moments.v2, 1.72993, error.v2 + 4 * 0.00048);
}

// The van der Pol oscillator with eps = 3: the density is concentrated around the limit cycle. The
// moments are the means of `fpkcheck mcs --time 4e6` with the seeds 11, 12 and 13, with standard
// errors of 1.5e-4 and 3.4e-4.
TEST(Formula, HasARelaxationOscillation) {
  const auto p =
      tests::with_impulses(system_of("3*(y^2-1)*v + y"), tests::gaussian_impulses(1, 0.5));
  const auto [solution, summary] = solve_stationary_density(p, {.max_seconds = 60});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_EQ(summary.transport, TransportScheme::characteristics);
  const auto& error = summary.error->moments;
  EXPECT_LE(std::abs(solution.energy_residual), error.v2 / solution.moments.v2 * (1 + 1e-9));
  EXPECT_LT(error.y2, 5e-3);
  EXPECT_NEAR(solution.moments.y2, 2.39511, error.y2 + 4 * 1.5e-4);
  EXPECT_NEAR(solution.moments.v2, 2.39528, error.v2 + 4 * 3.4e-4);
}

// A wall on the right at 0.4: the solver sees the mirrored and shifted formula.
TEST(Formula, IsTransformedToWallCoordinates) {
  const problem::WallParameters right{.right = 0.4, .right_restitution = 0.8};
  const problem::WallParameters left{.left = -0.4, .left_restitution = 0.8};
  const auto solve_moments = [](const problem::System& system) {
    const auto p = tests::with_noise(system, 0.2);
    return solve_stationary_density(tests::in_wall_coordinates(p), {.refinement = 0.7})
        .solution.moments;
  };
  const auto of_right = solve_moments(system_of("0.3*v + sinh(y) + 0.1*exp(v)*v", right));
  const auto of_left = solve_moments(system_of("0.3*v + sinh(y) + 0.1*exp(-v)*v", left));
  EXPECT_NEAR(of_right.y1, -of_left.y1, 1e-9);
  EXPECT_NEAR(of_right.y2, of_left.y2, 1e-9);
  EXPECT_NEAR(of_right.v2, of_left.v2, 1e-9);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
