#pragma once

#include <algorithm>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/motion/flight.hpp"

namespace fpkcheck::mcs {

/// A witness that looks away: for the burn-in. Any witness has these members.
struct NoWitness {
  void flight(const Flight&, double /*duration*/) {}  ///< free motion over this duration
  void impact(double /*velocity before*/) {}          ///< paper (2)
  void impulse(double /*velocity before*/, double /*amplitude*/) {}  ///< one term of paper (3)
};

/// One realisation of paper (1)-(2) itself, on y >= 0 and event by event: flights end exactly at
/// impacts, at impulses and at the end of the time asked for. What advance() does in lanes, written
/// plainly, for ensembles and for the tests.
class Trajectory {
 public:
  /// @param step longest flight, in radians of the local frequency, below pi (Flight::reach)
  Trajectory(const Oscillator& oscillator, ImpulseSource source, const State& start, double step)
      : oscillator_(oscillator),
        source_(source),
        state_(start),
        next_(source_.next()),
        step_(step) {}

  const State& state() const { return state_; }

  /// Follows the motion for a time and shows every event to the witness.
  template <class Witness>
  void advance(double duration, Witness& witness) {
    // Every turn of the loop either moves on in time or brings y to 0; at y = 0 the velocity has
    // been made >= 0, so that the turn after moves on. At rest (y = v = 0) time runs on to the next
    // impulse.
    while (duration > 0) {
      if (state_.y <= 0 && state_.v < 0) rebound(witness);
      const Flight flight(oscillator_, state_);
      double span = std::min({flight.reach(step_), next_.waiting, duration});
      State end = flight.at(span);
      const bool impact = end.y < 0 && state_.y > 0;
      if (impact) {
        span = flight.impact_time(span, end, true);
        end = {0, flight.at(span).v};
      }
      witness.flight(flight, span);
      duration -= span;
      next_.waiting -= span;
      state_ = {std::max(end.y, 0.0), end.v};
      if (next_.waiting <= 0) receive_impulse(witness);
    }
  }

 private:
  /// Paper (2), also for an impulse that pushes a resting oscillator into the wall.
  template <class Witness>
  void rebound(Witness& witness) {
    witness.impact(state_.v);
    state_ = {0, -oscillator_.restitution * state_.v};
  }

  template <class Witness>
  void receive_impulse(Witness& witness) {
    witness.impulse(state_.v, next_.amplitude);
    state_.v += next_.amplitude;
    next_ = source_.next();
  }

  Oscillator oscillator_;
  ImpulseSource source_;
  State state_;
  Impulse next_;  // and how long until then
  double step_;
};

}  // namespace fpkcheck::mcs
