#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "epc/polar/coordinates.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::polar {
namespace {

using tests::make_problem;

TEST(Coordinates, AreInverseToEachOther) {
  for (const double stiffness : {0.0, 1.0}) {
    const auto p = make_problem({.stiffness = stiffness, .cubic = 0.7});
    const AmplitudePhaseCoordinates coordinates(p);
    for (const double y : {0.0, 1e-8, 0.3, 5.0}) {
      EXPECT_NEAR(coordinates.displacement(coordinates.sqrt_twice_potential(y)), y,
                  1e-14 * (1 + y));
      const double h = 1e-5;
      EXPECT_NEAR(
          coordinates.sqrt_twice_potential_slope(y),
          (coordinates.sqrt_twice_potential(y + h) - coordinates.sqrt_twice_potential(y - h)) /
              (2 * h),
          1e-8);
      if (y > 0) {
        EXPECT_NEAR(coordinates.force_over_sqrt_twice_potential(y) *
                        coordinates.sqrt_twice_potential(y) / p.system.restoring_force()(y),
                    1, 1e-14);
      }
    }
  }
  // For K = k, rho^2/2 is the energy.
  const auto p = make_problem({.cubic = 0.7});
  EXPECT_NEAR(std::pow(AmplitudePhaseCoordinates(p).amplitude_of(0.6, -0.8), 2) / 2,
              0.32 + 0.18 + 0.7 * std::pow(0.6, 4) / 4, 1e-15);
}

TEST(PolarRule, HasTheAreaAndTheMomentsOfTheHalfDisc) {
  const auto p = make_problem({.cubic = 0});
  for (const std::vector<double>& breaks : {std::vector<double>{}, {0.4, 1.1}}) {
    const half_plane::QuadraturePoints points =
        amplitude::quadrature_points(AmplitudePhaseCoordinates(p), 2, breaks, {24, 24, 24});
    EXPECT_NEAR(points.weight.sum(), M_PI * 2, 1e-12);
    EXPECT_NEAR(points.weight.dot(points.y), 2.0 / 3 * 8, 1e-12);
    EXPECT_NEAR(points.weight.dot(points.v.cwiseAbs2()), M_PI * 16 / 8, 1e-12);
  }
}

// The equation K y^2 + mu y^4 / 2 = w^2 has a solution in closed form.
TEST(Coordinates, InvertTheEnergyOfACubicSpringAsItsClosedFormDoes) {
  for (const double cubic : {0.0, 1e-6, 0.7, 5.0}) {
    const AmplitudePhaseCoordinates coordinates(make_problem({.stiffness = 1.3, .cubic = cubic}));
    for (const double w : {1e-30, 1e-9, 0.4, 7.0, 1e5}) {
      const double y = w * std::sqrt(2 / (1.3 + std::sqrt(1.3 * 1.3 + 2 * cubic * w * w)));
      EXPECT_NEAR(coordinates.displacement(w) / y, 1, 4e-15) << cubic << ' ' << w;
    }
  }
}

TEST(PolarRule, PointsCarryTheirCoordinatesAndEnergies) {
  const auto p = make_problem({.cubic = 0.7});
  const AmplitudePhaseCoordinates coordinates(p);
  const auto points = amplitude::quadrature_points(coordinates, 2, {}, {7, 9, 7});
  EXPECT_EQ(points.size(), 63);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double y = points.y[i], v = points.v[i];
    EXPECT_NEAR(points.s[i], coordinates.amplitude_of(y, v), 1e-14);
    EXPECT_NEAR(points.t[i], coordinates.phase_of(y, v), 1e-13);
    EXPECT_NEAR(points.energy[i], v * v / 2 + p.system.potential()(y), 1e-14);
  }
}

// For k = 1 and mu = 0 amplitudes are radii.
const problem::Problem kLinear = make_problem({.cubic = 0});

// The integral of exp(-rho^2 / 2T) over the half-plane is pi T; beyond an energy E: pi T exp(-E/T).
TEST(PolarTail, ProbabilityBeyondIsThatOfAGaussian) {
  const double temperature = 0.7, rho = 3;
  const ExponentPolynomial q({{2, 0, -1 / (2 * temperature)}});
  const double expected = std::exp(-rho * rho / 2 / temperature);
  EXPECT_NEAR(half_plane::probability_beyond_contour(
                  q, amplitude::constant_amplitude_contour(AmplitudePhaseCoordinates(kLinear), rho),
                  temperature, std::log(M_PI * temperature)),
              expected, 1e-12 * expected);
}

TEST(PolarTail, RadiiAreThoseOfTheScaledHalfCircle) {
  const auto [least, greatest] = half_plane::scaled_radius_range(
      amplitude::constant_amplitude_contour(AmplitudePhaseCoordinates(kLinear), 2),
      {.x1 = 0.5, .x2 = 1});
  EXPECT_NEAR(least, 2, 1e-12);
  EXPECT_NEAR(greatest, 4, 1e-12);
}

TEST(PolarTail, LeadingFormIsTheSignOfTheHighestPowerOfTheAmplitude) {
  EXPECT_TRUE(amplitude::leading_form_of_amplitude_exponent<AmplitudePhaseCoordinates>(
                  ExponentPolynomial({{2, 0, -1}, {1, 1, 3}}), {1, 1})
                  .negative);
  const ExponentBehaviourAtInfinity rising =
      amplitude::leading_form_of_amplitude_exponent<AmplitudePhaseCoordinates>(
          ExponentPolynomial({{2, 0, -1}, {4, 0, 0.02}}), {1, 2});
  EXPECT_FALSE(rising.negative);
  EXPECT_EQ(rising.rising_fraction, 1);
  EXPECT_NEAR(rising.rises_from, 2.5, 0.06);  // in deviations of v
}

}  // namespace
}  // namespace fpkcheck::epc::polar
