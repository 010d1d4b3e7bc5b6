#pragma once

#include "mcs/motion/dormand_prince.hpp"
#include "mcs/motion/free_flight.hpp"
#include "numerics/simd/elementary_functions.hpp"

// formula_flight.hpp is compiled for several instruction sets.
namespace fpkcheck::mcs {
namespace {

/// Oscillator states of the SIMD lanes of a mask, packed for the evaluation of formulas.
template <class Real>
struct PackedOscillatorStates {
  static constexpr int W = simd::kWidth<Real>;
  struct alignas(64) Numbers {
    double at[W];
  };
  Numbers y, v;
  int lane[W], count = 0;

  template <class Mask>
  FPKCHECK_INLINE PackedOscillatorStates(const PhaseState<Real>& at, const Mask& wanted) {
    simd::store(at.y, y.at);
    simd::store(at.v, v.at);
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(wanted, i) == 0) continue;
      y.at[count] = y.at[i];
      v.at[count] = v.at[i];
      lane[count++] = i;
    }
  }

  /// Returns packed values in the SIMD lanes of the packed states, and 0 in all other SIMD lanes.
  FPKCHECK_INLINE Real unpack_to_lanes(const Numbers& values) const {
    Numbers result{};
    for (int k = 0; k < count; ++k) result.at[lane[k]] = values.at[k];
    return simd::load<Real>(result.at);
  }
};

/// Returns the force of free flights (evaluate_forces()) in the SIMD lanes of the mask `wanted`,
/// and 0 in other SIMD lanes.
template <class Real, class Mask>
FPKCHECK_INLINE Real forces_in_lanes(const SimulatedOscillator& oscillator,
                                     const PhaseState<Real>& at, const Mask& wanted) {
  typename PackedOscillatorStates<Real>::Numbers y, v, force;
  simd::store(at.y, y.at);
  simd::store(at.v, v.at);
  evaluate_forces(oscillator, simd::kWidth<Real>, y.at, v.at, force.at);
  return simd::select_or_zero(wanted, simd::load<Real>(force.at));
}

/// Returns the external force F(t) at the time t of each SIMD lane.
template <class Real>
FPKCHECK_INLINE Real external_force(const SimulatedOscillator& oscillator, const Real& t) {
  typename PackedOscillatorStates<Real>::Numbers times, force;
  simd::store(t, times.at);
  evaluate_external_forces(oscillator, simd::kWidth<Real>, times.at, force.at);
  return simd::load<Real>(force.at);
}

/// State and acceleration at the end of the previous flight, and the next trial step of the
/// integration, for each SIMD lane.
template <class Real>
struct FlightIntegratorState {
  PhaseState<Real> end{};
  Real acceleration{};
  Real step = simd::all_lanes_equal_to<Real>(1e300);
};

/// Free flight of an oscillator whose force is a formula: a step of the method of Dormand and
/// Prince of order 5(4) (Journal of Computational and Applied Mathematics 6, 1980), whose embedded
/// solution of order 4 limits the integration step. A flight of duration 0 replaces an inaccurate
/// integration step, so that no SIMD lane waits for other lanes. The motion in a FormulaFlight is
/// the Hermite polynomial of degree 5 with the position, velocity and acceleration at the two ends.
template <class Real>
class FormulaFlight : public FreeFlight<Real, 6> {
  using Base = FreeFlight<Real, 6>;
  using Base::a_;
  using Base::oscillator_;

 public:
  /// @param oscillator must outlive the flight
  /// @param time start time of the flight, used with SimulatedOscillator::external_force
  /// @param phase longest integration step in radians of the mean frequency; the error tolerance is
  /// proportional to phase^5, so that all integration steps are proportional to `phase`
  /// @param until_event upper limit of the integration step
  /// @param moving SIMD lanes to integrate; in other SIMD lanes the mass stays at its initial state
  template <class Mask>
  FPKCHECK_INLINE FormulaFlight(const SimulatedOscillator& oscillator,
                                const PhaseState<Real>& start, const Real& time, double phase,
                                const Real& until_event, const Mask& moving,
                                FlightIntegratorState<Real>& integrator)
      : Base(oscillator, start), start_time_(time), end_(start) {
    for (int n = 2; n <= Base::kOrder; ++n) a_[n] = Real{};
    const double relative = phase / kReferencePhase;
    const double tolerance = (oscillator.has_kinks ? kToleranceAtKinks : kTolerance) *
                             (relative * relative) * (relative * relative) * relative;
    const double longest = kLongestStep * relative / oscillator.frequency;
    const double shortest = longest * (oscillator.has_jumps ? kShortestAtJumps : kShortest);
    const Mask is_known = (start.y == integrator.end.y) & (start.v == integrator.end.v);
    const Mask none = moving & (start.v != start.v);
    const Mask unknown = moving & (is_known == none);
    Real first = integrator.acceleration;
    if (simd::any_mask_lane_set(unknown))
      first = simd::select(unknown, acceleration(start, Real{}, unknown), first);
    const Real trial = simd::lanewise_min(integrator.step, simd::all_lanes_equal_to<Real>(longest));
    step_ = simd::lanewise_min(trial, until_event);
    const Real error = take_step(first, moving) * (1.0 / tolerance);
    // A trial state outside the domain of the force formula gives the error estimate NaN.
    const Real known_error =
        simd::select(error == error, error, simd::all_lanes_equal_to<Real>(1e100));
    const Real next = step_ * error_controlled_step_factor(known_error);
    // If the force at the start of an integration step is not finite, shorter steps do not help.
    const Mask rejected = moving & (known_error > 1.0) & (step_ > shortest) & (first == first);
    const Mask accepted = moving & (rejected == none);
    // The next trial step does not decrease after an integration step that an event has shortened,
    // and after an initial state at which the force is not finite.
    const Mask keeps = (step_ == until_event) | (first != first);
    const Real after = simd::select(keeps, simd::lanewise_max(next, trial), next);
    integrator.step =
        simd::select(accepted, simd::lanewise_max(after, simd::all_lanes_equal_to<Real>(shortest)),
                     integrator.step);
    if (simd::any_mask_lane_set(rejected))
      undo_rejected_integration_steps(start, first, next, rejected, integrator);
    integrator.end.y = simd::select(moving, end_.y, integrator.end.y);
    integrator.end.v = simd::select(moving, end_.v, integrator.end.v);
    integrator.acceleration = simd::select(moving, end_acceleration_, integrator.acceleration);
  }
  FormulaFlight(SimulatedOscillator&&, const PhaseState<Real>&) = delete;

  /// Returns the duration of the integration step that the constructor has chosen.
  FPKCHECK_INLINE Real max_flight_duration(double /*phase*/) const { return step_; }

  /// Returns the state (y, v) at the time s of a FormulaFlight. At the end of the flight the
  /// returned state has no rounding errors of the Hermite polynomial.
  FPKCHECK_INLINE PhaseState<Real> state_at_time(const Real& s) const {
    const PhaseState<Real> at = Base::state_at_time(s);
    return {simd::select(s == step_, end_.y, at.y), simd::select(s == step_, end_.v, at.v)};
  }

 private:
  // Default of SimulationOptions::step in radians, for which the step-size control is tuned
  static constexpr double kReferencePhase = 0.9;
  // Tolerances of the relative error of an integration step. A kink of the force lowers the order
  // of the Runge-Kutta method. If SimulationOptions::step is halved, E[y^2] changes by less than
  // 1e-5 of its value for smooth and stiff forces and for kinks (test
  // Formula.MomentsDoNotDependOnTheStep).
  static constexpr double kTolerance = 1e-6, kToleranceAtKinks = 3e-8;
  static constexpr double kLongestStep = 0.6;
  // Shortest integration steps as fractions of the longest integration step. At a jump of the force
  // in v the error estimate would demand ever shorter integration steps while the velocity stays at
  // the jump.
  static constexpr double kShortest = 1e-9, kShortestAtJumps = 1.0 / 256;
  static constexpr double kSafety = 0.9, kLeastFactor = 0.2, kLargestFactor = 5;

  /// Returns the factor 0.9 error^(-3/16), within limits, by which the integration step changes,
  /// where the error is a multiple of the tolerance. The power -3/16 needs only square roots,
  /// whereas the usual power -1/5 needs a logarithm and an exponential.
  FPKCHECK_INLINE static Real error_controlled_step_factor(const Real& error) {
    const Real root = simd::square_root(simd::square_root(simd::square_root(error + 1e-100)));
    const Real factor = kSafety / (root * simd::square_root(root));
    return simd::lanewise_min(
        simd::lanewise_max(factor, simd::all_lanes_equal_to<Real>(kLeastFactor)),
        simd::all_lanes_equal_to<Real>(kLargestFactor));
  }

  /// Replaces rejected integration steps by steps of duration 0, and shortens the next trial steps.
  template <class Mask>
  FPKCHECK_INLINE void undo_rejected_integration_steps(const PhaseState<Real>& start,
                                                       const Real& first, const Real& next,
                                                       const Mask& rejected,
                                                       FlightIntegratorState<Real>& integrator) {
    step_ = simd::select(rejected, Real{}, step_);
    end_.y = simd::select(rejected, start.y, end_.y);
    end_.v = simd::select(rejected, start.v, end_.v);
    end_acceleration_ = simd::select(rejected, first, end_acceleration_);
    integrator.step = simd::select(rejected, next, integrator.step);
  }

  template <class Mask>
  FPKCHECK_INLINE Real acceleration(const PhaseState<Real>& at, const Real& after_start,
                                    const Mask& wanted) const {
    const Real restoring = -(forces_in_lanes(oscillator_, at, wanted) + oscillator_.force[0]);
    if (oscillator_.external_force == nullptr) return restoring;
    return restoring + external_force(oscillator_, start_time_ + after_start);
  }

  /// Takes one integration step in the SIMD lanes of `moving`.
  /// @param first acceleration at the start of the integration step
  /// @return the error estimate of the integration step relative to the extent of the motion
  template <class Mask>
  FPKCHECK_INLINE Real take_step(const Real& first, const Mask& moving) {
    using namespace dormand_prince;
    const Real h = step_, y = a_[0], v = a_[1];
    // The velocity at a Runge-Kutta stage is v + h u with the step h. Sums of the increments u,
    // instead of the velocities v + h u, avoid rounding errors of v.
    Real k[kStages] = {first}, u[kStages]{};
    Real moved{};
    PhaseState<Real> end{};
#pragma GCC unroll 1
    for (int stage = 1; stage < kStages; ++stage) {
      moved = Real{};
      for (int j = 0; j < stage; ++j) {
        u[stage] = u[stage] + kStage[stage][j] * k[j];
        moved = moved + kStage[stage][j] * u[j];
      }
      end = {y + h * (kNode[stage] * v + h * moved), v + h * u[stage]};
      k[stage] = acceleration(end, kNode[stage] * h, moving);
    }
    Real y_error{}, v_error{};
    for (int j = 0; j < kStages; ++j) {
      y_error = y_error + kError[j] * u[j];
      v_error = v_error + kError[j] * k[j];
    }
    // Differences between the state at the end of the integration step h and the Taylor polynomial
    // of degree 2 at the start of the step, divided by h^2 for the position and by h for the
    // velocity.
    const Real p = moved - 0.5 * first, q = u[kStages - 1] - first, r = k[kStages - 1] - first;
    const Real over = 1.0 / h;
    const auto set_in_moving_lanes = [&](Real & to, const Real& from)
        __attribute__((always_inline)) {
      to = simd::select(moving, from, to);
    };
    set_in_moving_lanes(end_.y, end.y);
    set_in_moving_lanes(end_.v, end.v);
    set_in_moving_lanes(end_acceleration_, k[kStages - 1]);
    set_in_moving_lanes(a_[2], 0.5 * first);
    set_in_moving_lanes(a_[3], (10.0 * p - 4.0 * q + 0.5 * r) * over);
    set_in_moving_lanes(a_[4], (7.0 * q - 15.0 * p - r) * (over * over));
    set_in_moving_lanes(a_[5], (6.0 * p - 3.0 * q + 0.5 * r) * (over * over * over));
    const double w = oscillator_.frequency;
    const auto size = [](const Real& x) __attribute__((always_inline)) {
      return simd::lanewise_max(x, -x);
    };
    const Real extent = w * (oscillator_.length + size(y)) + size(v);
    // The local frequency exceeds the mean frequency where the restoring force is steep, for
    // example in a stiff contact.
    const Real local = w + size(end_acceleration_) / extent;
    return h * (size(v_error) + local * size(h * y_error)) / extent;
  }

  Real start_time_, step_;
  PhaseState<Real> end_;
  Real end_acceleration_{};
};

}  // namespace
}  // namespace fpkcheck::mcs
