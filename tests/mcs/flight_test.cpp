#include "mcs/flight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

// Damped free motion of the linear oscillator, w = sqrt(k - c^2/4).
State exact_linear(const problem::System& system, const State& start, double t) {
  const double half_c = system.damping() / 2;
  const double w = std::sqrt(system.stiffness() - half_c * half_c);
  const double b = (start.v + half_c * start.y) / w;
  const double decay = std::exp(-half_c * t), cosine = std::cos(w * t), sine = std::sin(w * t);
  const double y = decay * (start.y * cosine + b * sine);
  return {y, -half_c * y + decay * w * (b * cosine - start.y * sine)};
}

State by_short_flights(const problem::System& system, State state, double t) {
  constexpr int kFlights = 64;
  for (int k = 0; k < kFlights; ++k) state = Flight(system, state).at(t / kFlights);
  return state;
}

double impact_time(const Flight& flight, double end) {
  return flight.impact_time(end, flight.at(end), true);
}

TEST(Flight, FollowsTheExactLinearMotion) {
  for (const double damping : {0.1, 1.5}) {
    const auto system =
        tests::make_problem({.damping = damping, .stiffness = 2, .cubic = 0}).system;
    const State start{1.3, -0.7};
    const Flight flight(system, start);
    const double t = flight.reach(0.7);
    // The first term left out, 0.7^13 / 13!, is 2e-12 of the amplitude; of v it is 13/0.7 times
    // that.
    for (const double s : {t / 3, t}) {
      EXPECT_NEAR(flight.at(s).y, exact_linear(system, start, s).y, 1e-11);
      EXPECT_NEAR(flight.at(s).v, exact_linear(system, start, s).v, 1e-10);
    }
  }
}

TEST(Flight, OfTheDuffingOscillatorConvergesWithTheOrderOfItsSeries) {
  const auto system = tests::paper_case(4).system;
  const State start{1.2, 1.9};
  const Flight flight(system, start);
  const auto error = [&](double phase) {
    const double t = flight.reach(phase);
    const State end = flight.at(t), exact = by_short_flights(system, start, t);
    return std::hypot(end.y - exact.y, end.v - exact.v);
  };
  // v is a polynomial of degree kOrder - 1, so that its error falls with t^kOrder.
  const double coarse = error(1.0), middle = error(0.5), fine = error(0.25);
  for (const double order : {std::log2(coarse / middle), std::log2(middle / fine)}) {
    EXPECT_GT(order, Flight::kOrder - 1.5) << coarse << " " << middle << " " << fine;
    EXPECT_LT(order, Flight::kOrder + 1.5) << coarse << " " << middle << " " << fine;
  }
}

TEST(Flight, IsAsAccurateAtLargeExcursionsAsAtSmallOnes) {
  // Energies from 1e-2 to 1e4: far beyond what any of the paper's cases visits.
  const auto system = tests::paper_case(4).system;
  for (const double v : {0.15, 1.5, 15.0, 150.0}) {
    for (const double angle : {0.0, 1.0, 2.0, 3.0}) {
      const double y = std::sqrt(v) * std::sin(angle);
      const State start{std::abs(y), v * std::cos(angle)};
      const Flight flight(system, start);
      const double t = flight.reach(0.7);
      const State end = flight.at(t), exact = by_short_flights(system, start, t);
      EXPECT_NEAR(end.v, exact.v, 2e-6 * v) << v << " " << angle;
      EXPECT_NEAR(end.y, exact.y, 2e-6 * std::sqrt(v)) << v << " " << angle;
    }
  }
}

TEST(Flight, FindsTheImpactOfTheLinearOscillatorToRounding) {
  const auto system = tests::make_problem({.cubic = 0}).system;
  const double w = std::sqrt(1 - 0.05 * 0.05);
  for (const double before : {0.6, 0.1, 1e-3, 1e-9}) {
    // A motion that is at the wall `before` from now: y ~ exp(-ct/2) sin(w (before - t)).
    const State start{std::sin(w * before),
                      -0.05 * std::sin(w * before) - w * std::cos(w * before)};
    const Flight flight(system, start);
    const double time = impact_time(flight, flight.reach(0.7));
    // 0.6 is at the far end, where the series errs by 1e-12.
    EXPECT_NEAR(time, before, before > 0.5 ? 1e-11 : 1e-14);
    EXPECT_NEAR(flight.at(time).y, 0.0, 1e-15);
  }
}

TEST(Flight, FindsAGrazingImpact) {
  const auto system = tests::paper_case(4).system;
  const Flight flight(system, {1e-12, -1e-9});
  const double end = flight.reach(0.7);
  ASSERT_LT(flight.at(end).y, 0.0);
  EXPECT_NEAR(impact_time(flight, end), 1e-3, 1e-6);
}

TEST(Flight, FindsImpactsTo1e10WhateverTheMotionBeforeThem) {
  const auto system = tests::paper_case(4).system;
  for (const double y : {1e-9, 1e-6, 1e-3, 0.1, 0.5}) {
    for (const double v : {-1e-9, -1e-6, -1e-3, -0.1, -1.0, -5.0, 1e-6, 0.02}) {
      const Flight flight(system, {y, v});
      const double end = flight.reach(1.2);
      if (flight.at(end).y >= 0) continue;
      const double time = impact_time(flight, end);
      EXPECT_LT(std::abs(flight.at(time).y), 1e-15 + 1e-14 * y) << y << " " << v;
    }
  }
}

TEST(Flight, FindsTheHighestPoint) {
  const auto system = tests::make_problem({.damping = 0.2, .cubic = 0}).system;
  // cos and sin of the damped motion from (y, 0) run backwards: the top lies `before` ahead.
  for (const double before : {0.5, 0.1, 1e-3}) {
    const Flight back(system, {0.8, 0});
    const State start = back.at(-before);
    const Flight flight(system, start);
    const double end = flight.reach(0.9);
    const double top = flight.peak_time(end, flight.at(end));
    EXPECT_NEAR(top, before, 1e-4);
    EXPECT_NEAR(flight.at(top).y, 0.8, 1e-8);
  }
}

TEST(Flight, FromTheWallDoesNotComeBackWithinItsReach) {
  for (const int number : {1, 2, 3, 4}) {
    const auto system = tests::paper_case(number).system;
    for (double v = 1e-300; v < 1e3; v *= 1e3) {
      const Flight flight(system, {0, v});
      EXPECT_GE(flight.at(flight.reach(1.0)).y, 0.0) << number << " " << v;
    }
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
