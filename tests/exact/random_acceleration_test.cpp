#include "exact/random_acceleration.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::exact {
namespace {

// Values with 50 digits, for 2D = 1
TEST(RandomAcceleration, HasTheExitTimesOfMasoliverAndPorra) {
  EXPECT_NEAR(random_acceleration_exit_time(0.5, 1, 0.5), 1.456442, 1e-6);
  EXPECT_NEAR(random_acceleration_exit_time(0.25, 1, 0.5), 1.358260, 1e-6);
  EXPECT_NEAR(random_acceleration_exit_time(0.75, 2, 0.5), 2.1561036, 1e-6);
}

}  // namespace
}  // namespace fpkcheck::exact
