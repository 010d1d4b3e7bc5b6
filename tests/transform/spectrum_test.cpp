#include "transform/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::transform {
namespace {

TEST(SpectralPeak, IsTheVertexOfTheParabolaAndHasItsHalfWidth) {
  // G = 1 - (w - 1.03)^2 on unequal steps; half of the height is at 1.03 +- sqrt(0.5).
  std::vector<double> frequencies, density;
  for (const double w : {0.0, 0.1, 0.3, 0.32, 0.5, 0.8, 1.0, 1.2, 1.5, 1.7, 1.75, 1.9}) {
    frequencies.push_back(w);
    density.push_back(1 - (w - 1.03) * (w - 1.03));
  }
  const auto peak = find_spectral_peak(frequencies, density);
  ASSERT_TRUE(peak);
  EXPECT_NEAR(peak->frequency, 1.03, 1e-12);
  EXPECT_NEAR(peak->density, 1, 1e-12);
  ASSERT_TRUE(peak->half_width);
  EXPECT_NEAR(*peak->half_width, std::sqrt(0.5), 1e-3);
}

TEST(SpectralPeak, IsAbsentWithoutALocalMaximum) {
  EXPECT_FALSE(find_spectral_peak({0, 1, 2}, {3, 2, 1}));
  EXPECT_FALSE(find_spectral_peak({0, 1}, {1, 2}));
}

TEST(SpectralPeak, HasNoHalfWidthIfOneSideStaysAboveHalfOfTheHeight) {
  const auto peak = find_spectral_peak({0, 1, 2, 3}, {0.6, 0.7, 1, 0.1});
  ASSERT_TRUE(peak);
  EXPECT_FALSE(peak->half_width);
}

}  // namespace
}  // namespace fpkcheck::transform
