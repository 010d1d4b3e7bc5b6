#include <gtest/gtest.h>

#include <cmath>

#include "epc/moment/density.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::moment {
namespace {

using tests::make_problem;

// For k = 1 and mu = 0 the energy contours are half-circles of radius sqrt(2 h).
const problem::Problem kLinear = make_problem({.cubic = 0});

// The integral of exp(-(y^2 + v^2) / 2T) over y > 0 is pi T; beyond an energy E: pi T exp(-E/T).
TEST(MomentTail, ProbabilityBeyondIsThatOfAGaussian) {
  const double temperature = 0.7, energy = 4;
  const ExponentPolynomial q({{2, 0, -1 / (2 * temperature)}, {0, 2, -1 / (2 * temperature)}});
  EXPECT_NEAR(probability_beyond_contour(
                  q, energy_contour_of_domain_edge(EnergySublevelSet(kLinear, energy)), temperature,
                  std::log(M_PI * temperature)),
              std::exp(-energy / temperature), 1e-4 * std::exp(-energy / temperature));
}

TEST(MomentTail, LargestOnAContourIncludesTheWallAndTheAxis) {
  const double energy = 2;  // radius 2
  EXPECT_NEAR(largest_exponent_on_contour(ExponentPolynomial({{1, 0, 1}}), kLinear, energy), 2,
              1e-12);
  EXPECT_NEAR(largest_exponent_on_contour(ExponentPolynomial({{0, 1, 1}}), kLinear, energy), 2,
              1e-12);
  EXPECT_NEAR(largest_exponent_on_contour(ExponentPolynomial({{0, 1, -1}}), kLinear, energy), 2,
              1e-12);
}

TEST(MomentTail, AFallIsFollowedToTheDepthAskedFor) {
  const ExponentPolynomial q({{2, 0, -1}, {0, 2, -1}});  // -2 h
  const ExponentDecayRange fall = find_exponent_decay_range(q, kLinear, 3, 100, 30);
  ASSERT_TRUE(fall.crossing.has_value());
  EXPECT_GE(*fall.crossing, 15 - 0.1);  // the scan for the peak starts at 1/40 of the first energy
  EXPECT_LT(*fall.crossing, 15 * 1.06);
  EXPECT_FALSE(find_exponent_decay_range(q, kLinear, 3, 10, 30)
                   .crossing.has_value());  // the scan ends too early
}

// Q_n rises between two radii before the final fall: a scan across the rise finds no energy.
TEST(MomentTail, ARiseEndsAFall) {
  // Along every direction q = -rho^2 + a rho^4 - b rho^6 rises between two radii.
  const double a = 0.1, b = 0.0031;  // 1 - 2a s + 3b s^2 = 0 at s = rho^2 = 7.4 and 14.1
  std::vector<ExponentMonomial> terms{{2, 0, -1}, {0, 2, -1}};
  for (const auto& [p, q, c] : std::vector<ExponentMonomial>{{4, 0, 1}, {2, 2, 2}, {0, 4, 1}}) {
    terms.push_back({p, q, a * c});
  }
  for (const auto& [p, q, c] :
       std::vector<ExponentMonomial>{{6, 0, 1}, {4, 2, 3}, {2, 4, 3}, {0, 6, 1}}) {
    terms.push_back({p, q, -b * c});
  }
  EXPECT_FALSE(find_exponent_decay_range(ExponentPolynomial(terms), kLinear, 2, 200, 30)
                   .crossing.has_value());
  EXPECT_TRUE(find_exponent_decay_range(ExponentPolynomial(terms), kLinear, 8, 200, 30)
                  .crossing.has_value());
}

TEST(MomentTail, RadiiAreThoseOfTheScaledContour) {
  const auto edge = energy_contour_of_domain_edge(EnergySublevelSet(kLinear, 2));  // radius 2
  const auto [least, greatest] = scaled_radius_range(edge, {.x1 = 0.5, .x2 = 1});
  EXPECT_NEAR(least, 2, 0.02);  // on the wall
  EXPECT_NEAR(greatest, 4, 0.02);
}

}  // namespace
}  // namespace fpkcheck::epc::moment
