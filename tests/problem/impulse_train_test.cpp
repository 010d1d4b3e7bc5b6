#include "problem/impulse_train.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "problem/input_error.hpp"
#include "trapezoid.hpp"

namespace fpkcheck::problem {
namespace {

ImpulseParameters train(double rate, double intensity, double mean) {
  return {.arrival_rate = rate, .law = "gaussian", .intensity = intensity, .mean = mean};
}

TEST(ImpulseTrain, MomentsAreTheIntegralsOfTheDensity) {
  const ImpulseTrain impulses(train(2.0, 0.6, 0.3));
  const ImpulseLaw& law = impulses.law();
  for (int j = 0; j < kMomentCount; ++j) {
    const double integral = tests::trapezoid(
        [&](double y) { return std::pow(y, j) * law.density(y); }, -6.0, 6.0, 4000);
    EXPECT_NEAR(law.moment(j), integral, 1e-12) << "order " << j;
  }
}

TEST(ImpulseTrain, IntensityIsRateTimesSecondMomentWhateverTheMean) {
  EXPECT_NEAR(ImpulseTrain(train(2.0, 0.6, 0.3)).intensity(), 0.6, 1e-15);
  EXPECT_NEAR(ImpulseTrain(train(2.0, 0.6, 0.3)).rate_moment(1), 2.0 * 0.3, 1e-15);
  EXPECT_NEAR(ImpulseTrain(train(1.0, 0.1, 0.0)).rate_moment(4), 3 * 0.1 * 0.1, 1e-15);
}

TEST(ImpulseTrain, RefusesWhatIsNoTrain) {
  EXPECT_THROW(ImpulseTrain(train(0, 0.1, 0)), InputError);
  EXPECT_THROW(ImpulseTrain(train(1, 0, 0)), InputError);
  EXPECT_THROW(ImpulseTrain(train(1, 0.1, 0.4)), InputError);  // mean^2 > E[Y^2]
  ImpulseParameters unknown = train(1, 0.1, 0);
  unknown.law = "cauchy";
  EXPECT_THROW(ImpulseTrain{unknown}, InputError);
}

}  // namespace
}  // namespace fpkcheck::problem
