#include <gtest/gtest.h>

#include <cmath>

#include "prepared_case.hpp"

namespace fpkcheck::control_variates {
namespace {

/// Returns the number of intervals of E[y^2] and E[y'^2] in `runs` runs that contain the exact
/// value.
int count_covering_intervals(const tests::PreparedCase& setup, int runs) {
  int count = 0;
  for (int seed = 1; seed <= runs; ++seed) {
    const ControlVariateResult r =
        setup.simulate_and_estimate(1e4, static_cast<std::uint64_t>(seed), 32);
    const auto holds = [&](const EstimatesWithAndWithoutControlVariates& e, double truth) {
      return std::abs(e.controlled.mean - truth) <
             r.estimates.confidence_interval_factor * e.controlled.standard_error;
    };
    count += holds(r.estimates.moments[1], tests::kTrueY2);
    count += holds(r.estimates.moments[4], tests::kTrueV2);
  }
  return count;
}

// The two intervals of a run are correlated. In the worst case there are 40 independent 95 %
// intervals: 38 expected with a deviation of 1.4. Fewer than 33 occur in one of 2000 correct
// suites.
constexpr int kRuns = 40, kFewest = 66;

TEST(Coverage, OfTheIntervalsIsNominal) {
  EXPECT_GE(count_covering_intervals(tests::prepared_case_1(), kRuns), kFewest);
}

TEST(Coverage, OfTheIntervalsIsNominalWithWrongControlFunctions) {
  const int count =
      count_covering_intervals(tests::prepared_case_1().with_scaled_control(1.1), kRuns);
  EXPECT_GE(count, kFewest);
  EXPECT_LT(count, 2 * kRuns);  // a coverage of 100 % would mean too wide intervals
}

}  // namespace
}  // namespace fpkcheck::control_variates
