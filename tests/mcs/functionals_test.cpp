#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>

#include "general_oscillators.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/passage.hpp"
#include "mcs/passage/probability_estimate.hpp"
#include "mcs/passage/rare_passages.hpp"
#include "mcs/sensitivities.hpp"
#include "mcs/spectrum.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using problem::System;
using transform::StateVariable;
using transform::Status;

problem::Problem linear_oscillator_problem() {
  return tests::with_impulses(System({.damping = 0.3, .stiffness = 1.44}, {.none = true}),
                              tests::gaussian_impulses(1, 0.1, 0.1));
}

// Limit for the differences of a handful of estimates with fixed seeds, in standard errors
constexpr double kMost = 3.5;

TEST(SimulatedSpectrum, IsThatOfTheLinearOscillator) {
  const std::vector<double> frequencies{0, 0.4, 0.9, 1.2, 1.5, 2, 3};
  for (const StateVariable variable : {StateVariable::y, StateVariable::ydot}) {
    const std::vector<double> lags{0, 0.35, 2, 7};
    const auto s =
        estimate_spectrum(linear_oscillator_problem(), {.time = 4e5}, variable, frequencies, lags);
    ASSERT_EQ(s.status, Status::ok) << s.reason;
    double squares = 0;
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
      const double w = frequencies[k];
      const double of_y = 0.1 / (std::numbers::pi * (std::pow(1.44 - w * w, 2) + 0.09 * w * w));
      const double exact = variable == StateVariable::y ? of_y : w * w * of_y;
      EXPECT_LE(std::abs(s.density[k] - exact), kMost * s.error[k] + 1e-12) << w;
      EXPECT_LE(s.error[k], 0.08 * exact + 1e-12) << w;
      if (s.error[k] > 0) squares += std::pow((s.density[k] - exact) / s.error[k], 2);
    }
    // The standard errors are neither far too small nor far too large.
    EXPECT_GT(squares, 1);
    EXPECT_LT(squares, 3 * static_cast<double>(frequencies.size()));
    const double variance = variable == StateVariable::y ? 0.1 / (2 * 0.3 * 1.44) : 0.1 / 0.6;
    EXPECT_LE(std::abs(s.variance - variance), kMost * s.variance_error);
    ASSERT_EQ(s.autocovariance.size(), lags.size());
    for (std::size_t k = 0; k < lags.size(); ++k) {
      const double w = std::sqrt(1.44 - 0.0225), t = lags[k], decay = std::exp(-0.15 * t);
      const double sine = 0.15 / w * std::sin(w * t) * (variable == StateVariable::y ? 1 : -1);
      const double exact = variance * decay * (std::cos(w * t) + sine);
      EXPECT_LE(std::abs(s.autocovariance[k] - exact), kMost * s.autocovariance_error[k]) << t;
      EXPECT_LE(s.autocovariance_error[k], 0.03 * variance) << t;
    }
  }
}

TEST(SimulatedSensitivities, AreThoseOfTheLinearOscillator) {
  const problem::Problem p = linear_oscillator_problem();
  std::vector<problem::ParameterDifferenceQuotient> parameters;
  for (const char* key : {"system.damping", "system.stiffness", "impulse.intensity"}) {
    parameters.push_back(problem::parameter_difference_quotient(p, key, 0.02));
  }
  const auto s = estimate_sensitivities(p, {.time = 2e5}, parameters);
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const auto& v2 = *std::ranges::find(s.expectations, "E[y'^2]",
                                      &transform::ExpectationDerivatives::expectation);
  const double exact[] = {-0.1 / (2 * 0.09), 0, 1 / 0.6};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(std::abs(v2.derivatives[k] - exact[k]), kMost * v2.errors[k]) << s.parameters[k];
  }
  // With common random numbers the errors are far below those of independent simulations, about
  // sqrt(2) 0.3 % / 2 % of the moment and parameter.
  EXPECT_LE(v2.errors[2], 0.05 * exact[2]);
}

// Values of an independent method, as in tests/fd_fpk/functionals/passage_test.cpp
TEST(SimulatedPassage, HasTheValuesOfAnIndependentMethodInCase1) {
  const auto passage = estimate_passage(tests::paper_case(1), {.time = 6e5}, {.level = 1.5}, {100});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  const auto expect = [](const std::optional<transform::ValueWithError>& found, double exact) {
    ASSERT_TRUE(found);
    EXPECT_LE(std::abs(found->value - exact), kMost * found->error) << exact;
    EXPECT_LE(found->error, 0.05 * exact);
  };
  expect(passage.hazard, 0.00945683);
  expect(passage.mean_from_point, 114.2740);
  expect(passage.mean_from_stationary, 102.1617);
  expect(passage.rice_rate, 0.0211775);
  expect(passage.survival_from_stationary[0], 0.96522 * std::exp(-0.945683));
}

// Values of finite differences below the level (tests/fd_fpk/functionals/energy_passage_test.cpp,
// and `fpkcheck passage CASE --energy 0.5 --methods fd-white` for the linear oscillator)
TEST(SimulatedPassage, HasTheValuesOfAnIndependentMethodForAnEnergyBarrier) {
  const auto expect = [](const std::optional<transform::ValueWithError>& found, double exact) {
    ASSERT_TRUE(found);
    EXPECT_LE(std::abs(found->value - exact), kMost * found->error) << exact;
    EXPECT_LE(found->error, 0.05 * exact);
  };
  const auto energy = [](double level) {
    return transform::PassageBarrier{transform::PassageBarrier::Quantity::energy, level};
  };
  const auto passage = estimate_passage(tests::paper_case(1), {.time = 4e5}, energy(1), {10});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_FALSE(passage.rice_rate);
  expect(passage.hazard, 0.0226652);
  expect(passage.mean_from_point, 49.684);
  expect(passage.mean_from_stationary, 42.142);
  expect(passage.probability_below, 0.89904);
  expect(passage.survival_from_stationary[0], 0.76107);
  const problem::Problem noisy =
      tests::with_noise(System({.damping = 0.1, .stiffness = 1}, {.none = true}), 0.1 / 1.7);
  const auto under_noise = estimate_passage(noisy, {.time = 5e5}, energy(0.5), {10});
  ASSERT_EQ(under_noise.status, Status::ok) << under_noise.reason;
  expect(under_noise.mean_from_point, 28.1915);
}

// Values of finite differences (`fpkcheck passage case1 --set noise.intensity=0.1 --energy 0.05`).
// With the interval between noise kicks of higher levels the mean time would be 8 % too large.
TEST(SimulatedPassage, ChangesTheEnergyInSmallStepsBelowALowLevel) {
  problem::Problem problem = tests::paper_case(1);
  problem.noise.intensity = 0.1;
  const transform::PassageBarrier low{transform::PassageBarrier::Quantity::energy, 0.05};
  const auto passage = estimate_passage(problem, {}, low, {1});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_NEAR(passage.mean_from_stationary->value, 0.3975, passage.mean_from_stationary->error);
  EXPECT_LE(passage.mean_from_stationary->error, 0.05 * 0.3975);
}

TEST(SimulatedPassage, StatesTheErrorByTheIntervalBetweenNoiseKicks) {
  const problem::Problem noisy =
      tests::with_noise(System({.damping = 0.1, .stiffness = 1}, {.none = true}), 0.1 / 1.7);
  const auto relative_error = [](const problem::Problem& problem) {
    const auto passage = estimate_passage(problem, {.time = 1e5}, {.level = 1}, {10});
    EXPECT_EQ(passage.has_kick_interval_errors, problem.noise.is_acting());
    return passage.mean_from_stationary->error / passage.mean_from_stationary->value;
  };
  // The second simulation takes half of the time. Its error and the first error give a stated error
  // of at least 1 + sqrt(3) standard errors.
  const double without_noise =
      relative_error(tests::with_impulses(System({.damping = 0.1, .stiffness = 1}, {.none = true}),
                                          tests::gaussian_impulses(1, 0.1 / 1.7, 0.1 / 1.7)));
  EXPECT_GT(relative_error(noisy), 2 * without_noise);
}

// Without given times the simulation chooses the times after its end.
TEST(SimulatedPassage, ChoosesTheTimesOfTheSurvivalProbabilities) {
  const auto chosen = estimate_passage(tests::paper_case(1), {.time = 1e5}, {.level = 1.5}, {});
  ASSERT_EQ(chosen.status, Status::ok) << chosen.reason;
  ASSERT_EQ(chosen.times.size(), 10u);
  EXPECT_NEAR(chosen.times.back(), 3 * chosen.mean_from_stationary->value, 10);
  const auto given =
      estimate_passage(tests::paper_case(1), {.time = 1e5}, {.level = 1.5}, chosen.times);
  for (std::size_t k = 0; k < chosen.times.size(); ++k) {
    EXPECT_DOUBLE_EQ(chosen.survival_from_stationary[k].value,
                     given.survival_from_stationary[k].value);
    EXPECT_DOUBLE_EQ(chosen.survival_from_point[k].value, given.survival_from_point[k].value);
  }
}

// Exact coverage of the interval of two standard errors: sum over all numbers of hits
TEST(ProbabilityEstimate, IsWithinTwoStandardErrorsOfTheProbability) {
  constexpr int kCount = 400;
  for (const double probability : {0.0, 0.0005, 0.002, 0.005, 0.02, 0.3, 0.5, 0.98, 0.999, 1.0}) {
    double covered = 0;
    for (int hits = 0; hits <= kCount; ++hits) {
      const auto [value, error] = probability_estimate(kCount, hits, hits);
      if (std::abs(value - probability) > 2 * error) continue;
      covered += boost::math::pdf(boost::math::binomial(kCount, probability), hits);
    }
    EXPECT_GT(covered, 0.92) << probability;
  }
  EXPECT_NEAR(2 * probability_estimate(kCount, 0, 0).error, 3.0 / kCount, 0.3 / kCount);
  EXPECT_NEAR(probability_estimate(kCount, 200, 200).error, 0.5 / std::sqrt(kCount), 2e-4);
}

// No passage is as short as 0.01, and no stay as long as 3000.
TEST(SimulatedPassage, StatesErrorsOfProbabilitiesWithoutHits) {
  const auto passage =
      estimate_passage(tests::paper_case(1), {.time = 1e5}, {.level = 1.5}, {0.01, 3000});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_EQ(passage.survival_from_point[0].value, 1);
  EXPECT_EQ(passage.survival_from_point[1].value, 0);
  EXPECT_EQ(passage.survival_from_stationary[1].value, 0);
  const double passages = 1e5 / passage.mean_from_stationary->value;
  EXPECT_NEAR(passage.survival_from_stationary[1].error * passages, std::sqrt(2), 0.1);
  EXPECT_NEAR(passage.survival_from_point[0].error, passage.survival_from_point[1].error, 1e-12);
  EXPECT_GT(passage.survival_from_point[0].error, 1e-4);
  EXPECT_LT(passage.survival_from_point[0].error, 5e-3);
  EXPECT_LT(passage.survival_from_stationary[0].error, 1e-5);
  EXPECT_FALSE(passage.has_kick_interval_errors);
}

// Values of `fpkcheck passage case1 --displacement 2 --methods characteristics --max-seconds 600`
TEST(RarePassages, HaveTheRateAndTheHazardOfAnIndependentMethod) {
  const problem::Problem problem = tests::in_wall_coordinates(tests::paper_case(1));
  const problem::MotionScales scales = problem::motion_scales(problem);
  SimulationPlan plan = make_simulation_plan(problem, {.seed = 5});
  plan.sampling_interval = 0.1;
  const double longest = 6 / scales.slowest_decay_rate;
  const RarePassageRun run =
      simulate_rare_passages(problem, plan, DisplacementBarriers{.half_width = 2}, scales, longest,
                             3e6, [](const auto&) { return false; });
  ASSERT_GE(run.replications.size(), 32u);
  EXPECT_GE(run.levels, 3u);
  EXPECT_NEAR(run.simulated_time, 3e6, 1e6);
  // Rate of upcrossings, and hazard times the time below the barrier, per replication
  std::vector<double> rates, residuals;
  double below = 0;
  constexpr double kRate = 0.00249335, kHazard = 0.00140076275;
  for (const RarePassages& r : run.replications) {
    double long_stays = 0, shortened = 0;
    for (const double stay : r.stays) {
      long_stays += stay >= longest ? 1 : 0;
      shortened += stay;
    }
    EXPECT_EQ(r.stays.size(), r.crossings);
    rates.push_back(r.weight * static_cast<double>(r.crossings));
    residuals.push_back(r.weight * (long_stays + kHazard * (r.time_above + shortened)) - kHazard);
    below += (1 - r.weight * r.time_above) / static_cast<double>(run.replications.size());
  }
  const MeanEstimate rate = estimate_unweighted_mean(rates),
                     residual = estimate_unweighted_mean(residuals);
  EXPECT_LE(std::abs(rate.mean - kRate), kMost * rate.standard_error);
  EXPECT_LE(rate.standard_error, 0.05 * kRate);
  EXPECT_LE(std::abs(residual.mean), kMost * residual.standard_error);
  EXPECT_LE(residual.standard_error, 0.05 * kHazard);
  EXPECT_NEAR(below, 0.99853, 2e-4);
}

// Values of `fpkcheck passage case1 --displacement 3 --methods characteristics --max-seconds 90`
TEST(SimulatedPassage, FindsRarePassagesBySplitting) {
  const double time = 1e6;
  const auto passage =
      estimate_passage(tests::paper_case(1), {.time = 4e6}, {.level = 3}, {10, time});
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_NE(passage.details.find("splitting"), std::string::npos) << passage.details;
  const auto expect = [](const std::optional<transform::ValueWithError>& found, double exact) {
    ASSERT_TRUE(found);
    EXPECT_LE(std::abs(found->value - exact), kMost * found->error) << exact;
    EXPECT_LE(found->error, 0.15 * exact);
  };
  constexpr double kHazard = 3.506e-6;
  expect(passage.hazard, kHazard);
  expect(passage.mean_from_stationary, 1 / kHazard);
  expect(passage.mean_from_point, 1 / kHazard);
  EXPECT_NEAR(passage.survival_from_stationary[1].value, std::exp(-time * passage.hazard->value),
              1e-3);
  EXPECT_NEAR(passage.survival_from_point[1].value, passage.survival_from_stationary[1].value,
              1e-2);
  EXPECT_NEAR(passage.survival_from_stationary[0].value, 1 - 10 * passage.rice_rate->value,
              passage.rice_rate->value * 10);
}

TEST(SimulatedPassage, SaysThatABarrierIsTooHigh) {
  const auto passage = estimate_passage(tests::paper_case(1), {.time = 1e4}, {.level = 5}, {100});
  EXPECT_EQ(passage.status, Status::not_converged);
  EXPECT_FALSE(passage.mean_from_stationary);
}

}  // namespace
}  // namespace fpkcheck::mcs
