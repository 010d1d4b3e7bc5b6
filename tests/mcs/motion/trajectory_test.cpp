#include "mcs/scalar_trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using tests::Flight;
using tests::NullObserver;
using tests::Trajectory;

constexpr double kAutomaticStepInRadians = 0.9;
// A rate so small that no impulse arrives in a test.
constexpr double kNever = 1e-12;

/// Records every event with its time.
struct Chronicle {
  struct Event {
    double time, velocity, amplitude;
  };
  double time = 0;
  double lowest = std::numeric_limits<double>::infinity();
  long flights = 0;
  std::vector<Event> impacts, impulses;

  void on_flight(const Flight& flight, double duration) {
    lowest = std::min(lowest, flight.state_at_time(duration).y);
    time += duration;
    ++flights;
  }
  void on_impact(double velocity) { impacts.push_back({time, velocity, 0}); }
  void on_impulse(double velocity, double amplitude) {
    impulses.push_back({time, velocity, amplitude});
  }
};

Trajectory make_trajectory(const problem::Problem& problem, const OscillatorState& start,
                           double step = kAutomaticStepInRadians) {
  return {tests::oscillator_of(problem), ImpulseSource(problem.impulses, 5, 0), start, step};
}

double total_energy(const problem::System& system, const OscillatorState& s) {
  return s.v * s.v / 2 + system.potential()(s.y);
}

TEST(Trajectory, OfTheLinearOscillatorHitsTheWallEveryHalfPeriodAndLosesItsShare) {
  const double r = 0.8, c = 0.1;
  const auto problem = tests::make_problem(
      {.damping = c, .cubic = 0, .restitution = r, .rate = kNever, .intensity = kNever});
  Trajectory trajectory = make_trajectory(problem, {0, 1});
  Chronicle seen;
  trajectory.advance(100, seen);
  const double w = std::sqrt(1 - c * c / 4), half_period = std::numbers::pi / w;
  ASSERT_EQ(seen.impacts.size(), static_cast<std::size_t>(100 / half_period));
  double velocity = 1;  // after the impact
  for (std::size_t n = 0; n < seen.impacts.size(); ++n) {
    velocity *= std::exp(-c * half_period / 2);
    // Between two impacts there are 4 or 5 flights with relative errors of v of at most 0.9^12 /
    // 12! = 6e-10.
    const double error = 3e-9 * static_cast<double>(n + 1);
    EXPECT_NEAR(seen.impacts[n].time, static_cast<double>(n + 1) * half_period, error);
    EXPECT_NEAR(seen.impacts[n].velocity / -velocity, 1.0, error);
    velocity *= r;
  }
  EXPECT_NEAR(seen.time, 100, 1e-12);
}

TEST(Trajectory, AnImpactTakesItsShareOfTheEnergyAndTurnsTheVelocity) {
  const double r = 0.6;
  const auto problem =
      tests::make_problem({.cubic = 1, .restitution = r, .rate = kNever, .intensity = kNever});
  // From just above the wall: the damping before and after the impact is negligible.
  const OscillatorState start{1e-9, -2};
  Trajectory trajectory = make_trajectory(problem, start);
  Chronicle seen;
  trajectory.advance(1e-8, seen);
  ASSERT_EQ(seen.impacts.size(), 1u);
  EXPECT_NEAR(seen.impacts[0].time, 0.5e-9, 1e-18);
  EXPECT_GT(trajectory.state().v, 0.0);
  EXPECT_NEAR(
      total_energy(problem.system, start) - total_energy(problem.system, trajectory.state()),
      (1 - r * r) / 2 * 4, 1e-7);
}

TEST(Trajectory, SatisfiesTheEnergyBalance) {
  // Balance of the energy: d/dt E = -c v^2 along flights, integrated by Simpson's rule, and the
  // energy changes at impulses and impacts.
  struct Ledger {
    const SimulatedOscillator& oscillator;
    double balance = 0, dissipated = 0;
    void on_flight(const Flight& flight, double duration) {
      const auto v2 = [&](double s) {
        return flight.state_at_time(s).v * flight.state_at_time(s).v;
      };
      constexpr int kPanels = 8;
      const double h = duration / kPanels;
      for (int p = 0; p < kPanels; ++p) {
        const double s = p * h;
        const double loss = oscillator.damping[0] * h / 6 * (v2(s) + 4 * v2(s + h / 2) + v2(s + h));
        balance -= loss;
        dissipated += loss;
      }
    }
    void on_impact(double v) {
      balance -= (1 - oscillator.left.restitution * oscillator.left.restitution) / 2 * v * v;
    }
    void on_impulse(double v, double amplitude) { balance += amplitude * (v + amplitude / 2); }
  };
  const auto problem = tests::make_problem({.cubic = 1, .restitution = 0.9, .intensity = 1});
  const SimulatedOscillator oscillator = tests::oscillator_of(problem);
  const OscillatorState start{0.5, 1.0};
  Trajectory trajectory(oscillator, ImpulseSource(problem.impulses, 5, 0), start,
                        kAutomaticStepInRadians);
  Ledger ledger{oscillator};
  const auto energy_of = [&](const OscillatorState& s) { return total_energy(problem.system, s); };
  for (int k = 0; k < 20; ++k) {
    trajectory.advance(50.0, ledger);
    // The step limit gives errors of 1e-6 of the dissipation in this case.
    EXPECT_NEAR(energy_of(trajectory.state()), energy_of(start) + ledger.balance,
                1e-5 * ledger.dissipated);
  }
}

TEST(Trajectory, ImpulsesArriveAtTheTimesOfTheSourceWithItsAmplitudes) {
  const auto problem = tests::make_problem({.rate = 2, .mean = 0.1});
  Trajectory trajectory = make_trajectory(problem, {1, 0});
  Chronicle seen;
  trajectory.advance(200, seen);
  ImpulseSource source(problem.impulses, 5, 0);
  double time = 0;
  ASSERT_GT(seen.impulses.size(), 300u);
  for (const auto& impulse : seen.impulses) {
    const Impulse expected = source.next_impulse();
    time += expected.waiting_time;
    EXPECT_NEAR(impulse.time, time, 1e-11);
    EXPECT_EQ(impulse.amplitude, expected.amplitude);
  }
}

TEST(Trajectory, DoesNotDependOnWhereItIsInterrupted) {
  const auto problem = tests::make_problem({.restitution = 0.7});
  Trajectory whole = make_trajectory(problem, {1, 0}), pieces = whole;
  NullObserver nobody;
  whole.advance(30, nobody);
  for (int k = 0; k < 3000; ++k) pieces.advance(0.01, nobody);
  EXPECT_NEAR(whole.state().y, pieces.state().y, 1e-6);
  EXPECT_NEAR(whole.state().v, pieces.state().v, 1e-6);
}

TEST(Trajectory, HalvingTheStepChangesOnlyTheErrorOfTheSeries) {
  const auto problem = tests::paper_case(1);
  Trajectory coarse = make_trajectory(problem, {1, 0}, 0.7),
             fine = make_trajectory(problem, {1, 0}, 0.35);
  NullObserver nobody;
  for (int k = 0; k < 20; ++k) {
    coarse.advance(10, nobody);
    fine.advance(10, nobody);
    EXPECT_NEAR(coarse.state().y, fine.state().y, 2e-6);
    EXPECT_NEAR(coarse.state().v, fine.state().v, 2e-6);
  }
}

TEST(Trajectory, IsReflectedAtOnceWhereAnImpulsePushesItIntoTheWall) {
  const auto problem =
      tests::make_problem({.restitution = 0.5, .rate = kNever, .intensity = kNever});
  Trajectory trajectory = make_trajectory(problem, {0, -1});
  Chronicle seen;
  trajectory.advance(1e-6, seen);
  ASSERT_EQ(seen.impacts.size(), 1u);
  EXPECT_EQ(seen.impacts[0].time, 0.0);
  EXPECT_NEAR(trajectory.state().v, 0.5, 1e-6);
}

TEST(Trajectory, AtRestStaysAtRestUntilAnImpulseAndIsThenThrownOff) {
  // All impulses act towards the wall: mean -1, deviation 1e-4.
  const double variance = 1e-8;
  const auto problem = tests::make_problem(
      {.restitution = 0.05, .rate = 0.1, .intensity = 0.1 * (1 + variance), .mean = -1});
  Trajectory trajectory = make_trajectory(problem, {0, 0});
  Chronicle seen;
  trajectory.advance(2000, seen);
  ASSERT_GT(seen.impulses.size(), 100u);
  EXPECT_EQ(seen.impulses[0].velocity, 0.0);
  ASSERT_FALSE(seen.impacts.empty());
  EXPECT_EQ(seen.impacts[0].time, seen.impulses[0].time);
  EXPECT_NEAR(seen.impacts[0].velocity, -1.0, 1e-3);
}

TEST(Trajectory, WithStrongLossesEndsAfterABoundedNumberOfEvents) {
  for (const double r : {0.05, 1e-3, 1e-8}) {
    // With one impulse per 1000 time units the motion decays below the smallest floating-point
    // number.
    for (const double rate : {100.0, 1.0, 1e-3}) {
      const auto problem =
          tests::make_problem({.restitution = r, .rate = rate, .intensity = 0.1 * rate});
      const double time = 400 / std::min(rate, 1.0);
      Trajectory trajectory = make_trajectory(problem, {1, 0});
      Chronicle seen;
      trajectory.advance(time, seen);
      const auto impulses = static_cast<double>(seen.impulses.size());
      EXPECT_NEAR(impulses, rate * time, 5 * std::sqrt(rate * time));
      // At most one impact per half-period (the frequency is below 3 here), and one per impulse.
      EXPECT_LT(static_cast<double>(seen.impacts.size()), time + impulses) << r << " " << rate;
      EXPECT_LT(static_cast<double>(seen.flights), 6 * time + 3 * impulses) << r << " " << rate;
      EXPECT_GT(seen.lowest, -1e-12);
      EXPECT_NEAR(seen.time, time, 1e-11 * time);
    }
  }
}

TEST(Trajectory, OfAnOverdampedOscillatorComesToRestWithoutImpacts) {
  const auto problem =
      tests::make_problem({.damping = 5, .cubic = 0, .rate = kNever, .intensity = kNever});
  Trajectory trajectory = make_trajectory(problem, {1, 0});
  Chronicle seen;
  trajectory.advance(1e4, seen);
  EXPECT_TRUE(seen.impacts.empty());
  EXPECT_LT(trajectory.state().y, 1e-100);
}

}  // namespace
}  // namespace fpkcheck::mcs
