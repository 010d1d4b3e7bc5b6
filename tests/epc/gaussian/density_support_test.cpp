#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "epc/form/exponent_polynomial.hpp"
#include "epc/gaussian/density_support.hpp"
#include "scaled_polynomials.hpp"
#include "trapezoid.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using tests::kSigma;
using tests::radial_quartic_polynomial;
using tests::scaled_polynomial;

TEST(DensitySupport, OfAGaussianReachesToWhereItIsNegligible) {
  const DensitySupport support(radial_quartic_polynomial(0), kSigma);
  const double radius = std::sqrt(-2 * std::log(DensitySupport::kNegligible));
  EXPECT_NEAR(support.smallest_support_radius(), radius, 1e-9);
  EXPECT_NEAR(support.largest_support_radius(), radius, 1e-9);
  EXPECT_NEAR(support.x1_max(), radius * kSigma.x1, 1e-9);
  EXPECT_NEAR(support.x2_max(), radius * kSigma.x2, 1e-9);
  EXPECT_NEAR(support.integral_relative_to_peak(), 2 * std::numbers::pi * kSigma.x1 * kSigma.x2,
              1e-12);
  EXPECT_NEAR(support.support_edge_to_peak_density_ratio() / DensitySupport::kNegligible, 1, 1e-6);
  // The estimate is exact for the tail of a Gaussian.
  EXPECT_NEAR(support.probability_outside_support() / DensitySupport::kNegligible, 1, 1e-6);
  EXPECT_TRUE(support.contains(0, 0.99 * radius * kSigma.x2));
  EXPECT_FALSE(support.contains(0, -1.01 * radius * kSigma.x2));
  EXPECT_FALSE(support.contains(1.01 * radius * kSigma.x1, 0));
}

TEST(DensitySupport, EndsWhereTheExponentBeginsToRise) {
  // Q' = 0 at rho^2 = 1/(4 quartic), where Q = -1/(16 quartic).
  const double quartic = 1.0 / 100;
  const DensitySupport support(radial_quartic_polynomial(quartic), kSigma);
  EXPECT_NEAR(support.smallest_support_radius(), 5, 1e-9);
  EXPECT_NEAR(support.largest_support_radius(), 5, 1e-9);
  EXPECT_NEAR(support.support_edge_to_peak_density_ratio(), std::exp(-6.25), 1e-9);
  EXPECT_FALSE(support.contains(0, 5.01 * kSigma.x2));
}

TEST(DensitySupport, EndsAtAMinimumThatIsDeepEnoughEvenWhenTheExponentFallsLater) {
  // Along w: a minimum of exp(-19) at 6.3, a maximum of exp(-12) at 9.6, then a monotone fall.
  const ExponentPolynomial q =
      scaled_polynomial({{2, 0, -0.5}, {0, 2, -1.125}, {0, 4, 0.02025}, {0, 6, -1.02515625e-4}});
  const DensitySupport support(q, kSigma);
  EXPECT_TRUE(leading_form(q, kSigma).negative);
  EXPECT_TRUE(support.contains(0, 6.2 * kSigma.x2));
  EXPECT_FALSE(support.contains(0, 6.4 * kSigma.x2));
  EXPECT_FALSE(support.contains(0, 9.6 * kSigma.x2));
}

TEST(DensitySupport, KeepsADipInTheMiddle) {
  // Two peaks at u = +-2, a factor exp(8) above the saddle at the origin.
  const ExponentPolynomial q = scaled_polynomial({{2, 0, 4}, {4, 0, -0.5}, {0, 2, -0.5}});
  const DensitySupport support(q, kSigma);
  EXPECT_NEAR(support.largest_exponent_in_support(), 8, 2e-3);
  EXPECT_TRUE(support.contains(0, 0));
  EXPECT_TRUE(support.contains(2 * kSigma.x1, 0));
  EXPECT_LT(support.support_edge_to_peak_density_ratio(), 1e-9);
  const double along_u = tests::trapezoid(
      [](double u) { return std::exp(4 * u * u - u * u * u * u / 2); }, -6, 6, 400);
  const double expected = along_u * std::sqrt(2 * std::numbers::pi) * kSigma.x1 * kSigma.x2 *
                          std::exp(-support.largest_exponent_in_support());
  EXPECT_NEAR(support.integral_relative_to_peak() / expected, 1, 1e-9);
}

TEST(DensitySupport, KeepsAShoulder) {
  // Along w: a minimum above 1e-6, a maximum below the peak, then a monotone fall.
  const ExponentPolynomial q =
      scaled_polynomial({{2, 0, -0.5}, {0, 2, -2}, {0, 4, 0.3}, {0, 6, -0.0135}});
  const DensitySupport support(q, kSigma);
  EXPECT_TRUE(support.contains(0, 3 * kSigma.x2));
  EXPECT_LT(support.support_edge_to_peak_density_ratio(), 1e-9);
}

TEST(DensitySupport, LeavesOutARiseAboveThePeak) {
  // Along w the minimum is shallow, and Q exceeds its peak before it falls at infinity.
  const ExponentPolynomial q =
      scaled_polynomial({{2, 0, -0.5}, {0, 2, -1}, {0, 4, 0.1}, {0, 8, -5e-6}});
  const DensitySupport support(q, kSigma);
  EXPECT_LT(support.smallest_support_radius(), 2.3);
  EXPECT_NEAR(support.support_edge_to_peak_density_ratio(), std::exp(-2.5), 1e-3);
  EXPECT_FALSE(support.contains(0, 5 * kSigma.x2));
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
