#include "workflows/study/reference/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::study {
namespace {

TEST(Reference, AgreedDigitsEndAtTheDifference) {
  EXPECT_EQ((ReferenceValue{1.2345678, 1.2345679}.agreed_digits(7)), 7);
  EXPECT_EQ((ReferenceValue{1.2345, 1.2346}.agreed_digits(7)), 4);
  EXPECT_EQ((ReferenceValue{1.2345, 1.2346}.agreed_digits(3)), 3);
  EXPECT_EQ((ReferenceValue{1.0, 2.0}.agreed_digits(7)), 1);
  EXPECT_EQ((ReferenceValue{0.5, 0.5}.agreed_digits(5)), 5);
  EXPECT_EQ((ReferenceValue{0.0, 1e-9}.agreed_digits(5)), 1);
  EXPECT_EQ((ReferenceValue{0.0, 0.0}.agreed_digits(5)), 1);
}

TEST(Reference, AgreesWithTheExactSolution) {
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1});
  const auto r = compute_reference(p, {.refinement = 1.2, .simulation_time = 1e5});
  ASSERT_EQ(r.failure, "");
  const double y2 = exact::linear_cumulant(p, 2, 0);
  EXPECT_NEAR(r.moments.at(1).value.seventh, y2, 1e-6 * y2);
  EXPECT_GE(r.moments.at(1).value.agreed_digits(7), 5);
  const exact::LinearDensity exact(p);
  ASSERT_EQ(r.y.size(), 20u);
  ASSERT_EQ(r.ydot.size(), 20u);
  for (const auto& [y, density] : r.y) {
    const double edges[] = {y - 1e-4, y + 1e-4};
    EXPECT_NEAR(density.seventh, exact.displacement_averages(edges)[0], 1e-5) << y;
  }
  for (const auto& [v, density] : r.ydot) {
    const double edges[] = {v - 1e-4, v + 1e-4};
    EXPECT_NEAR(density.seventh, exact.velocity_averages(edges)[0], 1e-5) << v;
  }
}

}  // namespace
}  // namespace fpkcheck::study
