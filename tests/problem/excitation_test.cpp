#include "problem/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/input_error.hpp"
#include "laws.hpp"

namespace fpkcheck::problem {
namespace {

ImpulseParameters train(double rate, double intensity, double mean) {
  return {.arrival_rate = rate, .law = "gaussian", .intensity = intensity, .mean = mean};
}

TEST(ImpulseTrain, IntensityIsRateTimesSecondMomentWhateverTheMean) {
  EXPECT_NEAR(ImpulseTrain(train(2.0, 0.6, 0.3)).intensity(), 0.6, 1e-15);
  EXPECT_NEAR(ImpulseTrain(train(2.0, 0.6, 0.3)).rate_times_moment(1), 2.0 * 0.3, 1e-15);
  EXPECT_NEAR(ImpulseTrain(train(1.0, 0.1, 0.0)).rate_times_moment(4), 3 * 0.1 * 0.1, 1e-15);
}

TEST(ImpulseTrain, EveryLawIsGivenTheIntensityAndTheMean) {
  for (const std::string& name : tests::law_names_without_table()) {
    ImpulseParameters parameters = train(2.0, 0.6, 0.3);
    parameters.law = name;
    const ImpulseTrain impulses(parameters);
    EXPECT_EQ(impulses.amplitude_law().name(), name);
    EXPECT_NEAR(impulses.intensity(), 0.6, 1e-15) << name;
    EXPECT_NEAR(impulses.rate_times_moment(1), 0.6, 1e-15) << name;
    EXPECT_NEAR(impulses.amplitude_law().amplitude_standard_deviation(), std::sqrt(0.3 - 0.09),
                1e-15)
        << name;
  }
}

TEST(ImpulseTrain, MirroredTwiceIsItself) {
  for (const std::string& name : tests::law_names_without_table()) {
    ImpulseParameters parameters = train(2.0, 0.6, 0.3);
    parameters.law = name;
    const ImpulseTrain impulses(parameters), mirrored = impulses.with_negated_amplitudes();
    for (int j = 0; j < kMomentCount; ++j) {
      EXPECT_EQ(mirrored.rate_times_moment(j),
                (j % 2 == 0 ? 1 : -1) * impulses.rate_times_moment(j))
          << name;
      EXPECT_EQ(mirrored.with_negated_amplitudes().rate_times_moment(j),
                impulses.rate_times_moment(j))
          << name;
    }
    // The mirrored parameters describe the mirrored law.
    const ImpulseTrain again(mirrored.impulse_parameters());
    EXPECT_NEAR(again.rate_times_moment(3), mirrored.rate_times_moment(3), 1e-15) << name;
  }
}

TEST(ImpulseTrain, RejectsInvalidParameters) {
  EXPECT_THROW(ImpulseTrain(train(0, 0.1, 0)), InputError);
  EXPECT_THROW(ImpulseTrain(train(1, 0, 0)), InputError);
  EXPECT_THROW(ImpulseTrain(train(1, 0.1, 0.4)), InputError);  // mean^2 > E[Y^2]
  ImpulseParameters unknown = train(1, 0.1, 0);
  unknown.law = "cauchy";
  try {
    ImpulseTrain{unknown};
    FAIL() << "accepted an unknown law";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_TRUE(said.starts_with("impulse.law = 'cauchy' (must be one of gaussian, ")) << said;
  }
}

}  // namespace
}  // namespace fpkcheck::problem
