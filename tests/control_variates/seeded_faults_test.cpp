#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "control_variates/control_variate_solution.hpp"
#include "mcs/deposit/sample_deposit_simd.hpp"
#include "mcs/scalar_trajectory.hpp"
#include "mcs/simulation/initial_state_sampler.hpp"
#include "prepared_case.hpp"

namespace fpkcheck::control_variates {
namespace {

using Names = std::vector<std::string>;
constexpr double kTime = 2e5;

/// Simulates a problem that differs from the problem of the control functions.
ControlVariateResult simulate_faulty_problem(const tests::Parameters& parameters,
                                             double time = kTime) {
  const auto& setup = tests::prepared_case_1();
  return setup.simulate_and_estimate(tests::make_problem(parameters),
                                     setup.simulation_options(time));
}

/// Returns the error of E[y^2], in standard errors.
double y2_error_in_standard_errors(const ControlVariateResult& result) {
  const auto& e = result.estimates.moments[1].controlled;
  return std::abs(e.mean - tests::kTrueY2) / e.standard_error;
}

bool contains_name(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

TEST(Checks, PassWithoutFaults) {
  const ControlVariateResult result = tests::prepared_case_1().simulate_and_estimate(kTime);
  EXPECT_EQ(result.checks.failed_check_names(), Names{});
  EXPECT_LT(y2_error_in_standard_errors(result), 4);
}

TEST(Checks, FindFlightsWhoseDampingIsOffByAThousandth) {
  const ControlVariateResult result = simulate_faulty_problem({.damping = 0.1 * 1.001});
  EXPECT_EQ(result.checks.failed_check_names(), Names{"flights"});
  EXPECT_EQ(result.checks.failed_deterministic_check_names(), Names{"flights"});
  const auto solution = solution_estimated_by_control_variates(ControlVariateResult(result));
  EXPECT_EQ(solution.status, transform::Status::failed);
  EXPECT_NE(solution.reason.find("flights"), std::string::npos);
  EXPECT_NEAR(result.checks.power, -1e-3, 1e-5);
  EXPECT_GT(y2_error_in_standard_errors(result), 100);
}

TEST(Checks, FindARestitutionThatIsOffByAThousandth) {
  const ControlVariateResult result = simulate_faulty_problem({.restitution = 0.98 + 1e-3});
  EXPECT_EQ(result.checks.failed_check_names(), Names{"restitution"});
  EXPECT_NEAR(result.checks.restitution, 1e-3, 1e-12);
  EXPECT_GT(y2_error_in_standard_errors(result), 100);
}

TEST(Checks, DetectALawThatControlFunctionsCannotDetect) {
  // A fault of 0.02 in the deviation, for a short run; a run 400 times as long detects 0.001.
  const ControlVariateResult result = simulate_faulty_problem({.intensity = 0.1 * 1.02 * 1.02});
  EXPECT_TRUE(contains_name(result.checks.failed_check_names(), "impulses"));
  EXPECT_FALSE(contains_name(result.checks.failed_check_names(), "flights"));
  // A statistical check gives a note, not a failure.
  const auto solution = solution_estimated_by_control_variates(ControlVariateResult(result));
  EXPECT_TRUE(solution.has_status_ok());
  EXPECT_NE(transform::metric_text(solution.metrics, "notes[0]")->find("impulses"),
            std::string::npos);
  EXPECT_GT(result.checks.mean_square, 4);
  EXPECT_LT(y2_error_in_standard_errors(result), 4);
}

TEST(Checks, FindImpulsesThatComeTooOften) {
  const ControlVariateResult result =
      simulate_faulty_problem({.rate = 1.02, .intensity = 0.1 * 1.02});
  EXPECT_TRUE(contains_name(result.checks.failed_check_names(), "impulses"));
  EXPECT_GT(result.checks.rate, 4);
}

/// Simulates flights and impacts in a separate loop, in which every impact is located too late.
mcs::DepositedSumsOfTrajectory deposit_late_impacts(const mcs::SampleDepositionPlan& plan,
                                                    const problem::Problem& problem,
                                                    std::uint32_t s, double late, double time) {
  const mcs::SimulatedOscillator oscillator = tests::oscillator_of(problem);
  mcs::ImpulseSource source(problem.impulses, 5, s);
  mcs::OscillatorState state = mcs::folded_initial_state(source, 0.65, 0.65);
  mcs::Impulse next = source.next_impulse();
  mcs::DepositedSumsOfTrajectory stream{.sums = mcs::DepositedSampleSums(plan.grid)};
  double y_before = 0, time_to_sample = plan.sampling_interval / 2, remaining = time + 400;
  while (remaining > 0) {
    const bool burns_in = remaining > time;
    if (state.y <= 0 && state.v < 0) {
      const double after = -oscillator.left.restitution * state.v;
      if (!burns_in) {
        mcs::deposit_impact(plan, stream.sums, y_before, state.v, after, 1);
        ++stream.impacts;
      }
      y_before = 0;
      state = {0, after};
    }
    const tests::Flight flight(oscillator, state);
    double span = std::min({flight.max_flight_duration(0.5), next.waiting_time, remaining});
    if (burns_in) span = std::min(span, remaining - time);
    mcs::OscillatorState end = flight.state_at_time(span);
    if (end.y < 0 && state.y > 0) {
      span = flight.impact_time(span, end, true) + late;
      end = flight.state_at_time(span);
      y_before = end.y;
      end.y = 0;
    }
    if (!burns_in) {
      for (; time_to_sample < span; time_to_sample += plan.sampling_interval) {
        const auto [y, v] = flight.state_at_time(time_to_sample);
        mcs::deposit_sample(plan, stream.sums, std::max(y, 0.0), v,
                            flight.polynomial_acceleration(time_to_sample), 1);
        for (std::size_t k = 0; k < mcs::kRecordedMomentPowers.size(); ++k) {
          stream.powers[k] += std::pow(y, mcs::kRecordedMomentPowers[k].first) *
                              std::pow(v, mcs::kRecordedMomentPowers[k].second);
        }
        ++stream.samples;
      }
      time_to_sample -= span;
    }
    remaining -= span;
    next.waiting_time -= span;
    state = {std::max(end.y, 0.0), end.v};
    if (next.waiting_time <= 0) {
      if (!burns_in) {
        stream.sums.impulses[0] += 1;
        stream.sums.impulses[1] += next.amplitude;
        stream.sums.impulses[2] += next.amplitude * next.amplitude;
      }
      state.v += next.amplitude;
      next = source.next_impulse();
    }
  }
  stream.time = time;
  return stream;
}

TEST(Checks, FindImpactsLocatedLateByAMillionth) {
  const auto& [problem, setup] = tests::prepared_case_1();
  const mcs::SimulationPlan plan =
      mcs::make_simulation_plan(problem, tests::prepared_case_1().simulation_options(kTime));
  for (const double late : {0.0, 1e-6}) {
    std::vector<mcs::DepositedSumsOfTrajectory> streams;
    for (std::uint32_t s = 0; s < 40; ++s) {
      streams.push_back(deposit_late_impacts(*plan.deposit, problem, s, late, 2000));
    }
    const Eigen::MatrixXd generator = stream_means_of_generated_splines(setup, streams);
    const StationaryFunctionalEstimates estimates = estimate_functionals(setup, generator, streams);
    const SimulationIdentityChecks judged =
        compute_simulation_identity_checks(setup, generator, streams, estimates);
    EXPECT_EQ(judged.failed_check_names(), late > 0 ? Names{"wall"} : Names{});
    if (late > 0) {
      EXPECT_GT(judged.wall_distance, 1e-7);
    }
    const auto& e = estimates.moments[1].controlled;
    EXPECT_NEAR(e.mean, tests::kTrueY2, 4 * e.standard_error + 1e-5);
  }
}

TEST(HotellingTest, HasItsNominalLevelAndDetectsAShiftedMean) {
  // Random vectors: rows of a fixed, nearly independent sequence of numbers.
  Eigen::MatrixXd values(3, 40);
  std::uint64_t state = 1;
  const auto uniform = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
  };
  int rejected = 0;
  constexpr int kRuns = 400;
  for (int run = 0; run < kRuns; ++run) {
    for (double& x : values.reshaped()) x = uniform() + uniform() + uniform();
    rejected += hotelling_test(values).p_value < 0.05;
  }
  EXPECT_NEAR(rejected, 0.05 * kRuns, 4 * std::sqrt(0.05 * kRuns));
  // The statistic is invariant to affine maps, and detects a nonzero mean.
  const double before = hotelling_test(values).statistic;
  Eigen::MatrixXd mixed = values;
  mixed.row(0) = 1e6 * values.row(0) + values.row(1);
  EXPECT_NEAR(hotelling_test(mixed).statistic, before, 1e-6 * before);
  values.array() += 0.5;
  EXPECT_LT(hotelling_test(values).p_value, 1e-4);
}

}  // namespace
}  // namespace fpkcheck::control_variates
