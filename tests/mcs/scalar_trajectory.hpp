#pragma once

#include <algorithm>
#include <utility>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/motion/duffing_flight.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::tests {

using Flight = mcs::DuffingFlight<double>;

/// Returns the oscillator that mcs::make_simulation_plan() makes for a problem.
inline mcs::SimulatedOscillator oscillator_of(const problem::Problem& problem) {
  return mcs::make_oscillator(problem, problem::motion_scales(problem));
}

/// Observer of a trajectory that ignores all events, for the burn-in. Other observers have the same
/// member functions.
struct NullObserver {
  void on_flight(const Flight&, double /*duration*/) {}  ///< after a free motion of this duration
  void on_impact(double /*velocity before*/) {}          ///< before an impact, paper (2)
  /// Called before an impulse, paper (3).
  void on_impulse(double /*velocity before*/, double /*amplitude*/) {}
};

/// One realisation of paper (1)-(2) on y >= 0, advanced event by event: flights end exactly at
/// impacts, at impulses and at the end of the duration. Scalar counterpart of
/// mcs::advance_all_streams().
class Trajectory {
 public:
  /// @param step longest flight, in radians of the local frequency, below pi
  /// (DuffingFlight::max_flight_duration)
  Trajectory(const mcs::SimulatedOscillator& oscillator, mcs::ImpulseSource source,
             const mcs::OscillatorState& start, double step)
      : oscillator_(oscillator),
        source_(std::move(source)),
        state_(start),
        next_(source_.next_impulse()),
        step_(step) {}

  const mcs::OscillatorState& state() const { return state_; }

  /// Advances the state by a duration and passes every event to the observer.
  template <class Observer>
  void advance(double duration, Observer& observer) {
    // Every iteration advances the time or ends at y = 0. At y = 0 the impact makes v >= 0, so the
    // next iteration advances the time. At rest (y = v = 0) the time advances to the next impulse.
    while (duration > 0) {
      if (state_.y <= 0 && state_.v < 0) apply_impact(observer);
      const Flight flight(oscillator_, state_);
      double span = std::min({flight.max_flight_duration(step_), next_.waiting_time, duration});
      mcs::OscillatorState end = flight.state_at_time(span);
      const bool impact = end.y < 0 && state_.y > 0;
      if (impact) {
        span = flight.impact_time(span, end, true);
        end = {0, flight.state_at_time(span).v};
      }
      observer.on_flight(flight, span);
      duration -= span;
      next_.waiting_time -= span;
      state_ = {std::max(end.y, 0.0), end.v};
      if (next_.waiting_time <= 0) apply_impulse(observer);
    }
  }

 private:
  /// Applies paper (2), also where an impulse pushes a resting oscillator into the wall.
  template <class Observer>
  void apply_impact(Observer& observer) {
    observer.on_impact(state_.v);
    state_ = {0, -oscillator_.left.restitution * state_.v};
  }

  template <class Observer>
  void apply_impulse(Observer& observer) {
    observer.on_impulse(state_.v, next_.amplitude);
    state_.v += next_.amplitude;
    next_ = source_.next_impulse();
  }

  mcs::SimulatedOscillator oscillator_;
  mcs::ImpulseSource source_;
  mcs::OscillatorState state_;
  mcs::Impulse next_;  // next impulse; `waiting` is the remaining time until this impulse
  double step_;
};

}  // namespace fpkcheck::tests
