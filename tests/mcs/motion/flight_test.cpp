#include "mcs/motion/duffing_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mcs/motion/polynomial_flight.hpp"
#include "mcs/scalar_trajectory.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using tests::Flight;

SimulatedOscillator paper_oscillator(int number) {
  return tests::oscillator_of(tests::paper_case(number));
}

SimulatedOscillator duffing_oscillator(double k, double mu, double damping = 0.1) {
  return {.force = {0, k, 0, mu, 0, 0},
          .damping = {damping, 0, 0},
          .kind = SimulatedOscillator::Kind::duffing_at_wall,
          .left = {.exists = true}};
}

// Damped free motion of the linear oscillator, w = sqrt(k - c^2/4).
OscillatorState exact_linear_state(const SimulatedOscillator& oscillator,
                                   const OscillatorState& start, double t) {
  const double half_c = oscillator.damping[0] / 2;
  const double w = std::sqrt(oscillator.force[1] - half_c * half_c);
  const double b = (start.v + half_c * start.y) / w;
  const double decay = std::exp(-half_c * t), cosine = std::cos(w * t), sine = std::sin(w * t);
  const double y = decay * (start.y * cosine + b * sine);
  return {y, -half_c * y + decay * w * (b * cosine - start.y * sine)};
}

OscillatorState state_by_short_flights(const SimulatedOscillator& oscillator, OscillatorState state,
                                       double t) {
  constexpr int kFlights = 64;
  for (int k = 0; k < kFlights; ++k) state = Flight(oscillator, state).state_at_time(t / kFlights);
  return state;
}

double impact_time_of_flight(const Flight& flight, double end) {
  return flight.impact_time(end, flight.state_at_time(end), true);
}

TEST(Flight, FollowsTheExactLinearMotion) {
  for (const double damping : {0.1, 1.5}) {
    const SimulatedOscillator oscillator = duffing_oscillator(2, 0, damping);
    const OscillatorState start{1.3, -0.7};
    const Flight flight(oscillator, start);
    const double t = flight.max_flight_duration(0.7);
    // The first omitted term of y, 0.7^13 / 13!, is 2e-12 of the amplitude; that of v is 13/0.7
    // times larger.
    for (const double s : {t / 3, t}) {
      EXPECT_NEAR(flight.state_at_time(s).y, exact_linear_state(oscillator, start, s).y, 1e-11);
      EXPECT_NEAR(flight.state_at_time(s).v, exact_linear_state(oscillator, start, s).v, 1e-10);
    }
  }
}

TEST(Flight, OfTheDuffingOscillatorConvergesWithTheOrderOfItsSeries) {
  const SimulatedOscillator oscillator = paper_oscillator(4);
  const OscillatorState start{1.2, 1.9};
  const Flight flight(oscillator, start);
  const auto error = [&](double phase) {
    const double t = flight.max_flight_duration(phase);
    const OscillatorState end = flight.state_at_time(t),
                          exact = state_by_short_flights(oscillator, start, t);
    return std::hypot(end.y - exact.y, end.v - exact.v);
  };
  // v is a polynomial of degree kOrder - 1: its error is proportional to t^kOrder.
  const double coarse = error(1.0), middle = error(0.5), fine = error(0.25);
  for (const double order : {std::log2(coarse / middle), std::log2(middle / fine)}) {
    EXPECT_GT(order, Flight::kOrder - 1.5) << coarse << " " << middle << " " << fine;
    EXPECT_LT(order, Flight::kOrder + 1.5) << coarse << " " << middle << " " << fine;
  }
}

TEST(Flight, IsAsAccurateAtLargeExcursionsAsAtSmallOnes) {
  // Energies from 1e-2 to 1e4, far above those of the paper's cases.
  const SimulatedOscillator oscillator = paper_oscillator(4);
  for (const double v : {0.15, 1.5, 15.0, 150.0}) {
    for (const double angle : {0.0, 1.0, 2.0, 3.0}) {
      const double y = std::sqrt(v) * std::sin(angle);
      const OscillatorState start{std::abs(y), v * std::cos(angle)};
      const Flight flight(oscillator, start);
      const double t = flight.max_flight_duration(0.7);
      const OscillatorState end = flight.state_at_time(t),
                            exact = state_by_short_flights(oscillator, start, t);
      EXPECT_NEAR(end.v, exact.v, 2e-6 * v) << v << " " << angle;
      EXPECT_NEAR(end.y, exact.y, 2e-6 * std::sqrt(v)) << v << " " << angle;
    }
  }
}

TEST(Flight, FindsTheImpactOfTheLinearOscillatorToRounding) {
  const SimulatedOscillator oscillator = duffing_oscillator(1, 0);
  const double w = std::sqrt(1 - 0.05 * 0.05);
  for (const double before : {0.6, 0.1, 1e-3, 1e-9}) {
    // Motion that has an impact at the time `before`: y ~ exp(-ct/2) sin(w (before - t)).
    const OscillatorState start{std::sin(w * before),
                                -0.05 * std::sin(w * before) - w * std::cos(w * before)};
    const Flight flight(oscillator, start);
    const double time = impact_time_of_flight(flight, flight.max_flight_duration(0.7));
    // At 0.6, the far end of the flight, the error of the series is 1e-12.
    EXPECT_NEAR(time, before, before > 0.5 ? 1e-11 : 1e-14);
    EXPECT_NEAR(flight.state_at_time(time).y, 0.0, 1e-15);
  }
}

TEST(Flight, FindsAGrazingImpact) {
  const SimulatedOscillator oscillator = paper_oscillator(4);
  const Flight flight(oscillator, {1e-12, -1e-9});
  const double end = flight.max_flight_duration(0.7);
  ASSERT_LT(flight.state_at_time(end).y, 0.0);
  EXPECT_NEAR(impact_time_of_flight(flight, end), 1e-3, 1e-6);
}

TEST(Flight, FindsImpactsTo1e10WhateverTheMotionBeforeThem) {
  const SimulatedOscillator oscillator = paper_oscillator(4);
  for (const double y : {1e-9, 1e-6, 1e-3, 0.1, 0.5}) {
    for (const double v : {-1e-9, -1e-6, -1e-3, -0.1, -1.0, -5.0, 1e-6, 0.02}) {
      const Flight flight(oscillator, {y, v});
      const double end = flight.max_flight_duration(1.2);
      if (flight.state_at_time(end).y >= 0) continue;
      const double time = impact_time_of_flight(flight, end);
      EXPECT_LT(std::abs(flight.state_at_time(time).y), 1e-15 + 1e-14 * y) << y << " " << v;
    }
  }
}

TEST(Flight, FindsTheHighestPoint) {
  const SimulatedOscillator oscillator = duffing_oscillator(1, 0, 0.2);
  // The damped motion backwards from the maximum (y, 0), which is then `before` ahead.
  for (const double before : {0.5, 0.1, 1e-3}) {
    const Flight back(oscillator, {0.8, 0});
    const OscillatorState start = back.state_at_time(-before);
    const Flight flight(oscillator, start);
    const double end = flight.max_flight_duration(0.9);
    const double top = flight.displacement_peak_time(end, flight.state_at_time(end));
    EXPECT_NEAR(top, before, 1e-4);
    EXPECT_NEAR(flight.state_at_time(top).y, 0.8, 1e-8);
  }
}

TEST(Flight, FromTheWallDoesNotComeBackWithinItsReach) {
  for (const int number : {1, 2, 3, 4}) {
    const SimulatedOscillator oscillator = paper_oscillator(number);
    for (double v = 1e-300; v < 1e3; v *= 1e3) {
      const Flight flight(oscillator, {0, v});
      EXPECT_GE(flight.state_at_time(flight.max_flight_duration(1.0)).y, 0.0) << number << " " << v;
    }
  }
}

// Compares the formulas for k y + mu y^3 with those for any polynomial force.
TEST(Flight, OfTheDuffingOscillatorIsThatOfAnyForce) {
  const SimulatedOscillator oscillator = duffing_oscillator(1, 0.7);
  for (const OscillatorState& start :
       {OscillatorState{0, 1}, OscillatorState{1.2, 0.4}, OscillatorState{20, -300}}) {
    const Flight a(oscillator, start);
    const PolynomialFlight<double, Flight::kOrder> b(oscillator, start);
    const double t = a.max_flight_duration(0.9);
    EXPECT_NEAR(a.state_at_time(t).y, b.state_at_time(t).y, 1e-13 * std::abs(start.y + start.v));
    EXPECT_NEAR(a.state_at_time(t).v, b.state_at_time(t).v, 1e-13 * std::abs(start.y + start.v));
    EXPECT_NEAR(a.acceleration(start), b.polynomial_acceleration(0),
                1e-13 * std::abs(start.v + 1e4));
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
