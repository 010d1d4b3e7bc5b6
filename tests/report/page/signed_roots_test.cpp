#include "report/page/signed_roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fpkcheck::report {
namespace {

TEST(SignedRoots, ComeBackWithTheirSign) {
  const std::vector<double> values{-2, 2, 0, 0.5, -1e-4, 1e-6};
  const auto [largest, roots] = signed_roots(values);
  EXPECT_EQ(largest, 2);
  EXPECT_EQ(roots[0], -32767);
  EXPECT_EQ(roots[3], 16384);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double q = roots[k] / 32767.0;
    EXPECT_NEAR(std::copysign(q * q, q) * largest, values[k], 0.03 * std::abs(values[k]));
  }
}

TEST(SignedRoots, OfNothingAreNothing) {
  EXPECT_EQ(signed_roots(std::vector<double>{0, 0}).roots, (std::vector<std::int16_t>{0, 0}));
}

}  // namespace
}  // namespace fpkcheck::report
