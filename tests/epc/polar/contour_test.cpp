#include "epc/polar/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_cases.hpp"

namespace fpkcheck::epc::polar {
namespace {

using tests::make_problem;

// For k = 1 and mu = 0 amplitudes are radii.
const problem::Problem kLinear = make_problem({.cubic = 0});

// The integral of exp(-rho^2 / 2T) over the half-plane is pi T; beyond an energy E: pi T exp(-E/T).
TEST(PolarTail, ProbabilityBeyondIsThatOfAGaussian) {
  const double temperature = 0.7, rho = 3;
  const Polynomial q({{2, 0, -1 / (2 * temperature)}});
  const double expected = std::exp(-rho * rho / 2 / temperature);
  EXPECT_NEAR(
      half_plane::probability_beyond_contour(q, contour_of_amplitude(Coordinates(kLinear), rho),
                                             temperature, std::log(M_PI * temperature)),
      expected, 1e-12 * expected);
}

TEST(PolarTail, RadiiAreThoseOfTheScaledHalfCircle) {
  const auto [least, greatest] =
      half_plane::radius_range(contour_of_amplitude(Coordinates(kLinear), 2), {.x1 = 0.5, .x2 = 1});
  EXPECT_NEAR(least, 2, 1e-12);
  EXPECT_NEAR(greatest, 4, 1e-12);
}

TEST(PolarTail, LeadingFormIsTheSignOfTheHighestPowerOfTheAmplitude) {
  EXPECT_TRUE(leading_form_in_amplitude(Polynomial({{2, 0, -1}, {1, 1, 3}}), {1, 1}).negative);
  const LeadingForm rising =
      leading_form_in_amplitude(Polynomial({{2, 0, -1}, {4, 0, 0.02}}), {1, 2});
  EXPECT_FALSE(rising.negative);
  EXPECT_EQ(rising.rising_fraction, 1);
  EXPECT_NEAR(rising.rises_from, 2.5, 0.06);  // in deviations of v
}

}  // namespace
}  // namespace fpkcheck::epc::polar
