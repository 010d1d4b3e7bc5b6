#pragma GCC diagnostic ignored "-Wpsabi"  // SIMD vectors are inlined, never passed to functions

#include "numerics/simd/elementary_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::simd {
namespace {

using Wide = simd::SimdVectorTypes<8>::Real;

TEST(Elementary, LogarithmAndSineAreThoseOfTheLibrary) {
  for (int n = 0; n < 100000; ++n) {
    const double x = std::exp2(-52.0 * n / 100000) * (1 - 0.3 * (n % 7) / 7);
    EXPECT_NEAR(value_in_lane(simd::logarithm(simd::all_lanes_equal_to<Wide>(x)), 3), std::log(x),
                4e-16 * -std::log(x))
        << x;
    const double t = 2.0 * n / 100000 - 1;
    EXPECT_NEAR(value_in_lane(simd::sine_of_quarter_turns(simd::all_lanes_equal_to<Wide>(t)), 5),
                std::sin(M_PI_2 * t), 5e-16);
  }
}

TEST(Elementary, ExponentialIsThatOfTheLibrary) {
  for (int n = -70000; n <= 70000; ++n) {
    const double x = 0.01 * n, exact = std::exp(x);
    EXPECT_NEAR(value_in_lane(simd::exponential(simd::all_lanes_equal_to<Wide>(x)), 2), exact,
                5e-16 * exact)
        << x;
  }
}

TEST(Elementary, OneNumberHasTheBitsOfALane) {
  for (int n = 1; n < 10000; ++n) {
    const double x = 1e-3 * n;
    EXPECT_EQ(simd::logarithm(x),
              value_in_lane(simd::logarithm(simd::all_lanes_equal_to<Wide>(x)), 0));
    EXPECT_EQ(simd::exponential(x),
              value_in_lane(simd::exponential(simd::all_lanes_equal_to<Wide>(x)), 7));
  }
}

}  // namespace
}  // namespace fpkcheck::simd
