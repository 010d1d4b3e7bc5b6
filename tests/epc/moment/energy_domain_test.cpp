#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "epc/moment/energy_domain.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::moment {
namespace {

using std::numbers::pi;
using tests::make_problem;

using half_plane::QuadraturePoints;

double wall_integral(const numerics::QuadratureRule& wall, auto&& f) {
  double sum = 0;
  for (Eigen::Index i = 0; i < wall.size(); ++i) sum += wall.weights[i] * f(wall.points[i]);
  return sum;
}

double integral_over_domain(const QuadraturePoints& points, auto&& f) {
  double sum = 0;
  for (Eigen::Index i = 0; i < points.y.size(); ++i) {
    sum += points.weight[i] * f(points.y[i], points.v[i]);
  }
  return sum;
}

// For k = 4 the domain is the half-ellipse 2 y^2 + v^2/2 <= level.
TEST(EnergyDomain, OfALinearOscillatorIsAHalfEllipse) {
  const double level = 3;
  const EnergySublevelSet domain(make_problem({.stiffness = 4, .cubic = 0}), level);
  const double a = std::sqrt(level / 2), b = std::sqrt(2 * level);
  EXPECT_NEAR(domain.y_max(), a, 1e-14);
  EXPECT_NEAR(domain.v_max(), b, 1e-14);
  EXPECT_EQ(domain.y_low(), 0);
  const QuadraturePoints quadrature_points = domain.quadrature_points(12, 10);
  EXPECT_NEAR(integral_over_domain(quadrature_points, [](double, double) { return 1.0; }),
              pi * a * b / 2, 1e-13);
  EXPECT_NEAR(integral_over_domain(quadrature_points, [](double y, double) { return y; }),
              2 * a * a * b / 3, 1e-13);
  EXPECT_NEAR(integral_over_domain(quadrature_points, [](double, double v) { return v * v; }),
              pi * a * b * b * b / 8, 1e-12);
  EXPECT_NEAR(
      wall_integral(domain.left_wall_quadrature_rule(8), [](double v) { return -v * v * v; }),
      b * b * b * b / 4, 1e-12);
}

// Area of the domain as an integral over y, by midpoints after the substitution y = y_max sin(phi).
TEST(EnergyDomain, RuleConvergesOnADuffingOscillator) {
  const EnergySublevelSet domain(make_problem({.cubic = 2}), 5);
  const auto bell = [&](double y, double v) {
    return std::exp(-domain.energy(y, v)) * (1 + v * y);
  };
  const double coarse = integral_over_domain(domain.quadrature_points(14, 14), bell);
  const double fine = integral_over_domain(domain.quadrature_points(40, 40), bell);
  EXPECT_NEAR(coarse, fine, 1e-8);
  double area = 0;
  constexpr int kCells = 2000;
  for (int i = 0; i < kCells; ++i) {
    const double phi = (i + 0.5) / kCells * pi / 2;
    const double y = domain.y_max() * std::sin(phi);
    area += 2 * domain.velocity_half_width(y) * domain.y_max() * std::cos(phi) * pi / 2 / kCells;
  }
  EXPECT_NEAR(
      integral_over_domain(domain.quadrature_points(40, 2), [](double, double) { return 1.0; }),
      area, 1e-6);
}

// For k = 1 and mean force 3, the minimum at y = 3 has an energy that is 4.5 below the energy at
// the wall.
TEST(EnergyDomain, OfAHeldOscillatorIsAnOvalUntilItMeetsTheWall) {
  const auto held = make_problem({.cubic = 0, .rate = 100, .intensity = 0.5, .mean = 0.03});
  const EnergySublevelSet oval(held, 2);
  EXPECT_NEAR(oval.y_low(), 1, 1e-12);
  EXPECT_NEAR(oval.y_max(), 5, 1e-12);
  EXPECT_EQ(oval.left_wall_quadrature_rule(8).size(), 0);
  EXPECT_NEAR(
      integral_over_domain(oval.quadrature_points(12, 10), [](double, double) { return 1.0; }),
      pi * 4, 1e-12);
  EXPECT_NEAR(
      integral_over_domain(oval.quadrature_points(12, 10), [](double y, double) { return y; }),
      pi * 12, 1e-11);

  // At this level the wall cuts the circle of radius 5 about (3, 0) at y = 0.
  const EnergySublevelSet cut(held, 12.5);
  EXPECT_EQ(cut.y_low(), 0);
  EXPECT_NEAR(cut.velocity_half_width(0), 4, 1e-12);
  EXPECT_NEAR(
      integral_over_domain(cut.quadrature_points(30, 10), [](double, double) { return 1.0; }),
      25 * (pi - std::acos(0.6)) + 12, 1e-8);
  EXPECT_NEAR(wall_integral(cut.left_wall_quadrature_rule(8), [](double) { return 1.0; }), 4,
              1e-12);
}

TEST(EnergyDomain, OfAnOscillatorPushedToTheWallBeginsAtTheWall) {
  const auto pushed = make_problem({.cubic = 0, .rate = 100, .intensity = 0.5, .mean = -0.03});
  const EnergySublevelSet domain(pushed, 3.5);  // y^2/2 + 3 y = 3.5 at y = 1
  EXPECT_NEAR(domain.y_max(), 1, 1e-12);
  EXPECT_NEAR(domain.velocity_half_width(0), std::sqrt(7.0), 1e-12);
  const QuadraturePoints quadrature_points = domain.quadrature_points(40, 10);
  for (Eigen::Index i = 0; i < quadrature_points.y.size(); ++i) {
    EXPECT_TRUE(domain.contains(quadrature_points.y[i], quadrature_points.v[i]));
  }
}

TEST(EnergyDomain, PointsCarryTheirCoordinatesAndEnergies) {
  const EnergySublevelSet domain(make_problem({.cubic = 2}), 5);
  const QuadraturePoints quadrature_points = domain.quadrature_points(9, 7);
  EXPECT_EQ(quadrature_points.size(), 63);
  EXPECT_EQ(quadrature_points.s, quadrature_points.y);
  EXPECT_EQ(quadrature_points.t, quadrature_points.v);
  for (Eigen::Index i = 0; i < quadrature_points.size(); ++i) {
    const double y = quadrature_points.y[i], v = quadrature_points.v[i];
    EXPECT_NEAR(quadrature_points.energy[i], v * v / 2 + y * y / 2 + y * y * y * y / 2, 1e-14);
  }
}

// Domains y^2 + v^2 <= 4: the whole disc, the part right of a wall at -1, and the part between
// walls at -1 and 0.5.
TEST(EnergyDomain, IsWhatWallsLeaveOfTheCircle) {
  const double level = 2;
  const auto circle = [&](const problem::WallParameters& walls) {
    return EnergySublevelSet(
        tests::with_noise(problem::System({.damping = 0.1, .stiffness = 1}, walls), 0.1), level);
  };
  const auto one = [](double, double) { return 1.0; };
  const auto area_from = [](double y) {  // area of the part of the circle right of y
    return 4 * std::acos(y / 2) - y * std::sqrt(4 - y * y);
  };
  const EnergySublevelSet whole = circle({.none = true});
  EXPECT_NEAR(whole.y_low(), -2, 1e-12);
  EXPECT_NEAR(whole.y_low(), -2, 1e-12);
  EXPECT_NEAR(integral_over_domain(whole.quadrature_points(12, 10), one), 4 * pi, 1e-12);
  EXPECT_EQ(whole.left_wall_quadrature_rule(8).size(), 0);
  EXPECT_EQ(whole.right_wall_quadrature_rule(8).size(), 0);
  EXPECT_TRUE(whole.contains(-1.9, 0.1));

  const EnergySublevelSet gap = circle({.left = -1, .left_restitution = 1});
  EXPECT_NEAR(integral_over_domain(gap.quadrature_points(20, 10), one), area_from(-1), 1e-11);
  EXPECT_NEAR(wall_integral(gap.left_wall_quadrature_rule(8), [](double v) { return v; }), -1.5,
              1e-12);
  EXPECT_FALSE(gap.contains(-1.1, 0));

  const EnergySublevelSet strip =
      circle({.left = -1, .left_restitution = 1, .right = 0.5, .right_restitution = 1});
  EXPECT_NEAR(integral_over_domain(strip.quadrature_points(20, 10), one),
              area_from(-1) - area_from(0.5), 1e-11);
  EXPECT_NEAR(wall_integral(strip.right_wall_quadrature_rule(8), [](double v) { return v; }),
              3.75 / 2, 1e-12);
  EXPECT_NEAR(wall_integral(strip.left_wall_quadrature_rule(8), [](double v) { return v; }), -1.5,
              1e-12);
  EXPECT_FALSE(strip.contains(0.6, 0));
  EXPECT_EQ(strip.y_max(), 0.5);
}

// For V = -y^2/2 + y^4/4 the domain has two parts if h < 1/4: (y^2 - 1)^2 <= 4 h.
TEST(EnergyDomain, HasAPartInEachWell) {
  const auto p = tests::with_noise(
      problem::System({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true}), 0.1);
  const EnergySublevelSet wells(p, 0.16);
  ASSERT_EQ(wells.y_intervals().size(), 2U);
  EXPECT_NEAR(wells.y_low(), -std::sqrt(1.8), 1e-12);
  EXPECT_NEAR(wells.y_intervals()[0].right, -std::sqrt(0.2), 1e-12);
  EXPECT_NEAR(wells.y_max(), std::sqrt(1.8), 1e-12);
  const QuadraturePoints quadrature_points = wells.quadrature_points(30, 8);
  EXPECT_EQ(quadrature_points.size(), 480);
  EXPECT_NEAR(integral_over_domain(quadrature_points, [](double y, double) { return y; }), 0,
              1e-12);
  // With y dy = d(y^2)/2 the half-width is a semicircle in u = y^2 - 1. The integral of |y| over
  // one part is (1/2) pi/2 (0.8)^2 / sqrt 2 * 2.
  EXPECT_NEAR(integral_over_domain(quadrature_points, [](double y, double) { return std::abs(y); }),
              2 * pi / 2 * 0.64 / std::numbers::sqrt2, 1e-10);
  EXPECT_EQ(EnergySublevelSet(p, 0.26).y_intervals().size(), 1U);
}

}  // namespace
}  // namespace fpkcheck::epc::moment
