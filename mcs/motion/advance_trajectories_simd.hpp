#pragma once

#include "mcs/deposit/sample_deposit_simd.hpp"
#include "mcs/motion/advance_trajectories.hpp"
#include "mcs/motion/duffing_flight.hpp"
#include "mcs/motion/formula_flight.hpp"
#include "mcs/motion/multiplicative_kick.hpp"
#include "mcs/motion/polynomial_flight.hpp"
#include "mcs/motion/sample_statistics_simd.hpp"
#include "mcs/motion/scalar_events.hpp"
#include "numerics/simd/simd.hpp"

// Files that include advance_trajectories_simd.hpp are compiled for different instruction sets. All
// functions of advance_trajectories_simd.hpp are inlined or have internal linkage, since the linker
// could otherwise keep a copy with instructions that the processor lacks.

namespace fpkcheck::mcs {
namespace {

/// Motion of an oscillator of SimulatedOscillator::Kind::duffing_at_wall: the only wall is at y =
/// 0, the mass never rests on the wall, and no noise acts between impulses.
struct DuffingMotion {
  template <class Real>
  using Flight = DuffingFlight<Real>;
  static constexpr bool kHasFormula = false;  ///< whether the force is a formula
  /// Whether the class supports two walls, no wall, and walls at positions other than y = 0
  static constexpr bool kHasAnyWalls = false;
  static constexpr bool kHasRest = false;  ///< whether the mass may rest on a wall
  static constexpr bool kHasKicks = false;
  static constexpr bool kDeposits = true;
};

template <int kOrder>
struct PolynomialMotion {
  template <class Real>
  using Flight = PolynomialFlight<Real, kOrder>;
  static constexpr bool kHasFormula = false;
  static constexpr bool kHasAnyWalls = true;
  static constexpr bool kHasRest = true;
  static constexpr bool kHasKicks = true;
  static constexpr bool kDeposits = false;
};

struct FormulaMotion {
  template <class Real>
  using Flight = FormulaFlight<Real>;
  static constexpr bool kHasFormula = true;
  static constexpr bool kHasAnyWalls = true;
  static constexpr bool kHasRest = true;
  static constexpr bool kHasKicks = true;
  static constexpr bool kDeposits = false;
};

/// State and statistical sums of several trajectories, one trajectory in each SIMD lane.
template <int W, class Motion>
struct SimdLaneStates {
  using Real = typename simd::SimdVectorTypes<W>::Real;
  using Mask = decltype(Real{} < Real{});
  using Flight = typename Motion::template Flight<Real>;
  template <class Number>
  using Array = SimdLaneArray<Number, W>;

  const StreamMotionParameters& motion;
  const SimulatedOscillator& oscillator;
  TrajectoryStream* const* streams;
  double* cells[W];  // histogram cells of each stream
  Real y{}, v{}, time_to_impulse{}, time_to_kick{}, time_to_sample{}, remaining{}, time_to_rest{};
  Real weight{};
  Real powers[kRecordedMomentPowers.size()]{};
  Real y5{}, y6{};
  Real force{}, force_y{}, force_v{};
  Real samples{}, impacts{}, flights{};
  Real noise_factor{}, impulse_factor{};  // sums of G = g^2 and of b^2
  Real left_momentum{}, left_wall_squared_impact_speeds{}, right_momentum{},
      right_wall_squared_impact_speeds{};
  Real rest_left{}, rest_right{};
  FlightIntegratorState<Real> integrator{};  // used if Motion::kHasFormula
  Real beyond_wall{};  // y of the flight polynomial at the next impact, 0 up to rounding

  FPKCHECK_INLINE SimdLaneStates(const StreamMotionParameters& m, TrajectoryStream* const* s)
      : motion(m), oscillator(m.oscillator), streams(s) {
    for (int i = 0; i < W; ++i)
      cells[i] = streams[i]->record.histogram.histogram_cell_weights().data();
  }

  template <class Self, class Visit>
  FPKCHECK_INLINE static void for_each_branch_member(Self& self, const Visit& visit_branch_member) {
    visit_branch_member(self.y, &TrajectoryBranch::y);
    visit_branch_member(self.v, &TrajectoryBranch::v);
    visit_branch_member(self.time_to_impulse, &TrajectoryBranch::time_to_impulse);
    visit_branch_member(self.time_to_sample, &TrajectoryBranch::time_to_sample);
    visit_branch_member(self.remaining, &TrajectoryBranch::remaining);
    if constexpr (Motion::kHasKicks)
      visit_branch_member(self.time_to_kick, &TrajectoryBranch::time_to_kick);
    if constexpr (Motion::kHasRest)
      visit_branch_member(self.time_to_rest, &TrajectoryBranch::time_to_rest);
  }
  FPKCHECK_INLINE void load_branch_states() {
    for_each_branch_member(
        *this, [&](Real & lanes, double TrajectoryBranch::*member) __attribute__((always_inline)) {
          Array<double> numbers;
          for (int i = 0; i < W; ++i) numbers.at[i] = streams[i]->branch.*member;
          lanes = simd::load<Real>(numbers.at);
        });
    Array<double> weights;
    for (int i = 0; i < W; ++i) weights.at[i] = branch_statistical_weight(motion, *streams[i]);
    weight = simd::load<Real>(weights.at);
  }
  FPKCHECK_INLINE void store_branch_states() const {
    for_each_branch_member(
        *this, [&](const Real& lanes, double TrajectoryBranch::*member)
                   __attribute__((always_inline)) {
                     for (int i = 0; i < W; ++i)
                       streams[i]->branch.*member = simd::value_in_lane(lanes, i);
                   });
  }

  FPKCHECK_INLINE void add_lane_sums_to_streams() const {
    const auto add_lanes_to_statistic = [&](const Real& sums,
                                            double TrajectoryStreamStatistics::*member)
        __attribute__((always_inline)) {
      for (int i = 0; i < W; ++i) streams[i]->record.*member += simd::value_in_lane(sums, i);
    };
    add_lanes_to_statistic(y5, &TrajectoryStreamStatistics::y5);
    add_lanes_to_statistic(y6, &TrajectoryStreamStatistics::y6);
    add_lanes_to_statistic(force, &TrajectoryStreamStatistics::force);
    add_lanes_to_statistic(force_y, &TrajectoryStreamStatistics::force_y);
    add_lanes_to_statistic(force_v, &TrajectoryStreamStatistics::force_v);
    add_lanes_to_statistic(noise_factor, &TrajectoryStreamStatistics::noise_factor);
    add_lanes_to_statistic(impulse_factor, &TrajectoryStreamStatistics::impulse_factor);
    add_lanes_to_statistic(samples, &TrajectoryStreamStatistics::samples);
    add_lanes_to_statistic(rest_left, &TrajectoryStreamStatistics::rest_left);
    add_lanes_to_statistic(rest_right, &TrajectoryStreamStatistics::rest_right);
    add_lanes_to_statistic(impacts, &TrajectoryStreamStatistics::impacts);
    add_lanes_to_statistic(left_momentum, &TrajectoryStreamStatistics::left_momentum);
    add_lanes_to_statistic(left_wall_squared_impact_speeds,
                           &TrajectoryStreamStatistics::left_wall_squared_impact_speeds);
    add_lanes_to_statistic(right_momentum, &TrajectoryStreamStatistics::right_momentum);
    add_lanes_to_statistic(right_wall_squared_impact_speeds,
                           &TrajectoryStreamStatistics::right_wall_squared_impact_speeds);
    for (int i = 0; i < W; ++i) {
      TrajectoryStreamStatistics& record = streams[i]->record;
      for (std::size_t p = 0; p < kRecordedMomentPowers.size(); ++p)
        record.powers[p] += simd::value_in_lane(powers[p], i);
      record.flights += static_cast<std::uint64_t>(simd::value_in_lane(flights, i));
    }
  }

  /// Applies the impact law, paper (2), at all walls; an impulse towards a wall on which the mass
  /// rests also causes an impact.
  FPKCHECK_INLINE void apply_impacts(const Mask& active) {
    if constexpr (Motion::kHasAnyWalls) {
      if (oscillator.left.exists)
        apply_impact(oscillator.left, 1, active, left_momentum, left_wall_squared_impact_speeds);
      if (oscillator.right.exists)
        apply_impact(oscillator.right, -1, active, right_momentum,
                     right_wall_squared_impact_speeds);
    } else {
      apply_impact(oscillator.left, 1, active, left_momentum, left_wall_squared_impact_speeds);
    }
  }

  /// Returns function(SIMD lane number) in the lanes of the mask `wanted`, and 0 in other lanes.
  template <class Function>
  FPKCHECK_INLINE static Real evaluate_in_lanes(const Mask& wanted, const Function& function) {
    Array<double> values{};
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(wanted, i) != 0) values.at[i] = function(i);
    }
    return simd::load<Real>(values.at);
  }

  /// Applies the impact law, paper (2), at one wall.
  /// @param inwards 1 at the left wall, -1 at the right wall
  FPKCHECK_INLINE void apply_impact(const SimulatedWall& wall, double inwards, const Mask& active,
                                    Real& momentum_sum, Real& energy_sum) {
    const double position = Motion::kHasAnyWalls ? wall.position : 0.0;
    const Real speed = -inwards * v;
    Mask impact = active & (inwards * (y - position) <= 0.0);
    if constexpr (Motion::kHasRest) {
      // If a positive contact force presses the mass on the wall, the mass returns to the wall at
      // any speed, and may come to rest.
      impact =
          impact & (time_to_rest < 0.0) & (wall.contact_force > 0 ? speed >= 0.0 : speed > 0.0);
    } else {
      impact = impact & (speed > 0.0);
    }
    if (!simd::any_mask_lane_set(impact)) return;
    const Real event_weight = simd::select_or_zero(impact, weight);
    if (motion.records) impacts = impacts + event_weight;
    Real after{};
    if (Motion::kHasAnyWalls && wall.formula != nullptr) {
      after = velocity_after_impact(wall, speed, impact, event_weight, momentum_sum, energy_sum);
    } else {
      if (motion.records) {
        momentum_sum = momentum_sum + event_weight * speed;
        energy_sum = energy_sum + event_weight * (speed * speed);
      }
      after = -wall.restitution * v;
      if constexpr (Motion::kHasRest) {
        if (wall.contact_force > 0)
          replace_bounces_by_geometric_sum(wall, speed, impact, after, momentum_sum, energy_sum);
      }
    }
    if constexpr (Motion::kDeposits) {
      if (motion.deposit) deposit_impacts(impact, after);
    }
    v = simd::select(impact, after, v);
  }

  /// Returns the velocity after impacts at a wall with a formula of the restitution coefficient
  /// r(u), and adds the changes of the momentum and the lost energies to the statistics. After an
  /// impact slower than SimulatedWall::rest_speed the bounces end after total_bounce_time() with
  /// the mass at rest: the bounces dissipate the remaining energy, and the wall transfers the
  /// momentum `speed` plus contact force times bounce time.
  FPKCHECK_INLINE Real velocity_after_impact(const SimulatedWall& wall, const Real& speed,
                                             const Mask& impact, const Real& event_weight,
                                             Real& momentum_sum, Real& energy_sum) {
    const Real r = evaluate_in_lanes(
        impact, [&](int i) __attribute__((always_inline)) {
          return restitution_at_speed(wall, simd::value_in_lane(speed, i));
        });
    Real after = -r * v, momentum = (1.0 + r) * speed,
         energy = (1.0 - r * r) * (speed * speed) * 0.5;
    if constexpr (Motion::kHasRest) {
      const Mask stays = impact & (speed < wall.rest_speed);
      if (wall.contact_force > 0 && simd::any_mask_lane_set(stays)) {
        const Real time = evaluate_in_lanes(
            stays, [&](int i) __attribute__((always_inline)) {
              return total_bounce_time(wall, simd::value_in_lane(speed, i));
            });
        time_to_rest = simd::select(stays, time, time_to_rest);
        after = simd::select(stays, Real{}, after);
        const Mask ends = stays & (time < std::numeric_limits<double>::infinity());
        momentum = simd::select(ends, speed + wall.contact_force * time, momentum);
        energy = simd::select(ends, speed * speed * 0.5, energy);
      }
    }
    if (motion.records) {
      momentum_sum = momentum_sum + event_weight * momentum;
      energy_sum = energy_sum + event_weight * energy;
    }
    return after;
  }

  /// Replaces the bounces after an impact slower than SimulatedWall::rest_speed by the sum of a
  /// geometric series, with the mass at the wall during the bounces.
  FPKCHECK_INLINE void replace_bounces_by_geometric_sum(const SimulatedWall& wall,
                                                        const Real& speed, const Mask& impact,
                                                        Real& after, Real& momentum_sum,
                                                        Real& energy_sum) {
    const double r = wall.restitution;
    const Mask stays = impact & (speed < wall.rest_speed);
    if (!simd::any_mask_lane_set(stays)) return;
    // Bounce n = 1, 2, .. starts at the speed u_n = r^n speed, with the restitution coefficient r,
    // and takes the time 2 u_n / contact_force. For r = 1 the bounces never end.
    constexpr double kNoEnd = 1e300;
    const double times = r < 1 ? 2 * r / ((1 - r) * wall.contact_force) : 0;
    const Real time = r < 1 ? speed * times : simd::all_lanes_equal_to<Real>(kNoEnd);
    time_to_rest = simd::select(stays, time, time_to_rest);
    after = simd::select(stays, Real{}, after);
    if (motion.records && r < 1) {
      const Real event_weight = simd::select_or_zero(stays, weight);
      momentum_sum = momentum_sum + event_weight * (speed * (r / (1 - r)));
      energy_sum = energy_sum + event_weight * (speed * speed * (r * r / (1 - r * r)));
    }
  }

  FPKCHECK_INLINE void deposit_impacts(const Mask& impact, const Real& after) {
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(impact, i) == 0) continue;
      deposit_impact(*motion.deposit, streams[i]->record.deposit,
                     simd::value_in_lane(beyond_wall, i), simd::value_in_lane(v, i),
                     simd::value_in_lane(after, i), simd::value_in_lane(weight, i));
    }
    beyond_wall = simd::select(impact, Real{}, beyond_wall);
  }

  FPKCHECK_INLINE void record_trajectory_samples(const Flight& flight, const Real& span,
                                                 const Mask& in_contact) {
    for (;;) {
      const Mask due = time_to_sample < span;
      if (!simd::any_mask_lane_set(due)) break;
      const Real time = simd::select_or_zero(due, time_to_sample);
      const PhaseState<Real> at = flight.state_at_time(time);
      if constexpr (Motion::kHasRest) {
        add_sample_to_statistics(at, due, due & in_contact & (time_to_rest <= time));
      } else {
        add_sample_to_statistics(at, due, due);
      }
      if (motion.records_displacement_series) append_to_displacement_series(at.y, due);
      if (motion.keeps_states) append_recorded_states(at, remaining - time, due);
      if constexpr (Motion::kDeposits) {
        if (motion.deposit) deposit_due_samples(at, flight.polynomial_acceleration(time), due);
      }
      time_to_sample =
          time_to_sample +
          simd::select_or_zero(due, simd::all_lanes_equal_to<Real>(motion.sampling_interval));
    }
    time_to_sample = time_to_sample - span;
  }

  FPKCHECK_INLINE void append_to_displacement_series(const Real& y_value, const Mask& due) const {
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(due, i) != 0)
        streams[i]->series.push_back(simd::value_in_lane(y_value, i));
    }
  }

  FPKCHECK_INLINE void append_recorded_states(const PhaseState<Real>& at, const Real& time_to_end,
                                              const Mask& due) const {
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(due, i) == 0) continue;
      streams[i]->states.push_back({simd::value_in_lane(time_to_end, i),
                                    simd::value_in_lane(at.y, i), simd::value_in_lane(at.v, i)});
    }
  }

  // Samples are deposited one by one, since the SIMD lanes of deposit_sample() hold the splines of
  // a single sample.
  FPKCHECK_INLINE void deposit_due_samples(const PhaseState<Real>& at, const Real& acceleration,
                                           const Mask& due) const {
    Array<double> ys, vs, as;
    simd::store(simd::lanewise_max(at.y, Real{}), ys.at);
    simd::store(at.v, vs.at);
    simd::store(acceleration, as.at);
#pragma GCC unroll 1
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(due, i) == 0) continue;
      deposit_sample(*motion.deposit, streams[i]->record.deposit, ys.at[i], vs.at[i], as.at[i],
                     simd::value_in_lane(weight, i));
    }
  }

  // SIMD lanes in which no sample is due get the sample weight 0.
  FPKCHECK_INLINE void add_sample_to_statistics(const PhaseState<Real>& at, const Mask& due,
                                                [[maybe_unused]] const Mask& at_rest) {
    const Real sample_weight = simd::select_or_zero(due, weight);
    add_weighted_monomials(at, sample_weight, powers);
    samples = samples + sample_weight;
    if constexpr (Motion::kHasFormula) {
      add_force_sums(at, sample_weight, due);
    }
    if (oscillator.impulse_factor != nullptr) add_impulse_factor_sums(at, sample_weight);
    Real into_bins = sample_weight;
    if constexpr (Motion::kHasRest) {
      const Real x = at.y, xx = x * x;
      y5 = y5 + sample_weight * (xx * xx * x);
      y6 = y6 + sample_weight * (xx * xx * xx);
      if (!motion.kicks.is_acting() && simd::any_mask_lane_set(at_rest)) {
        into_bins = simd::select(at_rest, Real{}, sample_weight);
        add_resting_samples(x, simd::select_or_zero(at_rest, weight));
      }
    }
    add_lane_samples_to_histograms(*motion.y_bins, *motion.v_bins, clamp_between_walls(at.y), at.v,
                                   into_bins, streams, cells);
  }

  FPKCHECK_INLINE void add_force_sums(const PhaseState<Real>& at, const Real& sample_weight,
                                      const Mask& due) {
    const PackedOscillatorStates<Real> states(at, due);
    typename PackedOscillatorStates<Real>::Numbers values;
    evaluate_ito_forces(oscillator, states.count, states.y.at, states.v.at, values.at);
    const Real weighted = sample_weight * states.unpack_to_lanes(values);
    force = force + weighted;
    force_y = force_y + weighted * at.y;
    force_v = force_v + weighted * at.v;
    if (motion.kicks.factor == nullptr) return;
    evaluate_noise_factor(motion.kicks, states.count, states.y.at, states.v.at, values.at);
    const Real g = states.unpack_to_lanes(values);
    noise_factor = noise_factor + sample_weight * (g * g);
  }

  FPKCHECK_INLINE void add_impulse_factor_sums(const PhaseState<Real>& at,
                                               const Real& sample_weight) {
    Array<double> factors;
    for (int i = 0; i < W; ++i) {
      factors.at[i] = mcs::impulse_factor(oscillator, simd::value_in_lane(at.y, i));
    }
    const Real b = simd::load<Real>(factors.at);
    impulse_factor = impulse_factor + sample_weight * (b * b);
  }

  FPKCHECK_INLINE void add_resting_samples(const Real& x, const Real& resting) {
    if (!oscillator.right.exists) {
      rest_left = rest_left + resting;
      return;
    }
    const Real there = simd::select(x > oscillator.right.position / 2, resting, Real{});
    rest_right = rest_right + there;
    rest_left = rest_left + (resting - there);
  }

  // A sample at the time of an impact may lie slightly behind the wall because of rounding.
  FPKCHECK_INLINE Real clamp_between_walls(const Real& x) const {
    Real between = x;
    if (Motion::kHasAnyWalls && oscillator.right.exists) {
      const double last = oscillator.right.position - motion.y_bins->bin_edge_epsilon();
      between = simd::lanewise_min(between, simd::all_lanes_equal_to<Real>(last));
    }
    if (!Motion::kHasAnyWalls || oscillator.left.exists)
      between = simd::lanewise_max(between, Real{});
    return between;
  }

  /// Adds the weight of each SIMD lane in the mask `lanes` to the bin that contains y_value.
  FPKCHECK_INLINE void add_weights_to_y_bins(
      std::vector<double> TrajectoryStreamStatistics::*bin_weights, const Real& y_value,
      const Mask& lanes) {
    if (!simd::any_mask_lane_set(lanes)) return;
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(lanes, i) == 0) continue;
      (streams[i]->record.*bin_weights)[(*motion.y_bins)(simd::value_in_lane(y_value, i))] +=
          simd::value_in_lane(weight, i);
    }
  }

  /// Ends a DuffingFlight at an impact in the time [0, span], if any, and counts a maximum of y.
  FPKCHECK_INLINE void end_flight_at_single_wall(const Flight& flight, Real& span,
                                                 PhaseState<Real>& end) {
    const Mask impact = (end.y < 0.0) & (y > 0.0);
    if (simd::any_mask_lane_set(impact)) {
      span = simd::select(impact, flight.impact_time(span, end, impact), span);
      const PhaseState<Real> at_wall = flight.state_at_time(span);
      end.v = simd::select(impact, at_wall.v, end.v);
      if (motion.deposit) beyond_wall = simd::select(impact, at_wall.y, beyond_wall);
      end.y = simd::select(impact, Real{}, end.y);
    }
    if (!motion.records) return;
    const Mask peak = (v > 0.0) & (end.v < 0.0);
    if (!simd::any_mask_lane_set(peak)) return;
    const Real height = flight.state_at_time(flight.displacement_peak_time(span, end)).y;
    add_weights_to_y_bins(&TrajectoryStreamStatistics::peaks, height, peak);
  }

  /// Ends a FreeFlight at the first impact within the time interval [0, span], if an impact occurs,
  /// and counts extremes of y. Since the velocity changes sign at most once in a flight, the values
  /// of y at the two ends and at the extreme determine the impacts. The signs of y at the two ends
  /// of a flight alone would miss the return to a wall with positive contact force, and a short
  /// excursion behind a wall.
  FPKCHECK_INLINE void end_flight_at_first_wall(const Flight& flight, Real& span,
                                                PhaseState<Real>& end, const Mask& free) {
    const SimulatedOscillator& o = oscillator;
    const Mask turned = free & (v * end.v < 0.0);
    Real turning{}, extreme = y;
    if (simd::any_mask_lane_set(turned)) {
      turning = flight.turning_time(span, end, turned);
      extreme = flight.state_at_time(turning).y;
    }
    const Mask none = turned & (v != v);
    const Mask low_turn = turned & (v < 0.0), high_turn = turned & (v > 0.0);
    Mask left_first = none, right_first = none, left = none, right = none;
    if (o.left.exists) {
      left_first = low_turn & (extreme < 0.0);
      left = free & (end.y < 0.0);
    }
    if (o.right.exists) {
      right_first = high_turn & (extreme > o.right.position);
      right = free & (end.y > o.right.position);
    }
    const Mask first = left_first | right_first;
    left = left_first | (left & (right_first == none));
    right = right_first | (right & (left_first == none));
    const Mask impact = left | right;
    if (simd::any_mask_lane_set(impact)) {
      const Real wall =
          simd::select(right, simd::all_lanes_equal_to<Real>(o.right.position), Real{});
      const Real inside = simd::select(right, simd::all_lanes_equal_to<Real>(-1.0),
                                       simd::all_lanes_equal_to<Real>(1.0));
      const Mask after_turn = turned & (first == none);
      const Real low = simd::select(after_turn, turning, Real{});
      const Real high = simd::select(first, turning, span);
      // The initial guess of the impact time comes from the parabola about the extreme of y, or
      // from the chord if y has no extreme in the flight.
      const Real from_extreme = extreme - wall;
      const Real of_first =
          1.0 - simd::square_root(simd::lanewise_max(from_extreme / (extreme - y), Real{}));
      const Real of_last =
          simd::square_root(simd::lanewise_max(from_extreme / (extreme - end.y), Real{}));
      const Real of_chord = (y - wall) / (y - end.y);
      const Real part = simd::select(first, of_first, simd::select(after_turn, of_last, of_chord));
      const Real guess =
          simd::lanewise_min(simd::lanewise_max(low + (high - low) * part, low), high);
      span = simd::select(impact, flight.impact_time(wall, inside, low, high, guess, impact), span);
      const PhaseState<Real> at_wall = flight.state_at_time(span);
      end.v = simd::select(impact, at_wall.v, end.v);
      end.y = simd::select(impact, wall, end.y);
    }
    if (!motion.records) return;
    add_weights_to_y_bins(&TrajectoryStreamStatistics::peaks, extreme,
                          high_turn & (right_first == none));
    add_weights_to_y_bins(&TrajectoryStreamStatistics::troughs, extreme,
                          low_turn & (left_first == none));
    if (o.right.exists) {
      add_weights_to_y_bins(
          &TrajectoryStreamStatistics::peaks,
          simd::all_lanes_equal_to<Real>(o.right.position - motion.y_bins->bin_edge_epsilon()),
          right);
    }
  }

  FPKCHECK_INLINE void apply_impulses_and_kicks(const Mask& active) {
    const Mask impulse_now = active & (time_to_impulse <= 0.0);
    if (motion.splitting) {  // kicks and splitting exclude each other
      if (!simd::any_mask_lane_set(impulse_now) &&
          !simd::any_mask_lane_set(active & (remaining <= 0.0)))
        return;
      store_branch_states();
      for (int i = 0; i < W; ++i) {
        TrajectoryStream& stream = *streams[i];
        if (simd::value_in_lane(impulse_now, i) != 0) apply_impulse(motion, stream);
        while (stream.branch.remaining <= 0 && !stream.is_on_main_branch())
          resume_pending_branch(stream);
      }
      load_branch_states();
      return;
    }
    Mask now = impulse_now;
    if constexpr (Motion::kHasKicks) now = now | (active & (time_to_kick <= 0.0));
    if (!simd::any_mask_lane_set(now)) return;
    Array<double> ys, vs, times_to_impulse, kicks, remaining_times;
    simd::store(remaining, remaining_times.at);
    simd::store(y, ys.at);
    simd::store(v, vs.at);
    simd::store(time_to_impulse, times_to_impulse.at);
    if constexpr (Motion::kHasKicks) simd::store(time_to_kick, kicks.at);
    TrajectoryStream* kicked[W];  // streams with kicks of multiplicative noise
    int kicked_lane[W], kicked_count = 0;
    for (int i = 0; i < W; ++i) {
      if (simd::value_in_lane(now, i) == 0) continue;
      TrajectoryStream& stream = *streams[i];
      TrajectoryBranch& b = stream.branch;
      b.y = ys.at[i];
      b.v = vs.at[i];
      b.remaining = remaining_times.at[i];
      if (times_to_impulse.at[i] <= 0) {
        apply_impulse(motion, stream);
        times_to_impulse.at[i] = b.time_to_impulse;
      }
      if constexpr (Motion::kHasKicks) {
        if (kicks.at[i] <= 0) {
          if (Motion::kHasFormula && motion.kicks.factor != nullptr) {
            kicked[kicked_count] = &stream;
            kicked_lane[kicked_count++] = i;
          } else {
            apply_noise_kick(motion, stream);
            kicks.at[i] = b.time_to_kick;
          }
        }
      }
      vs.at[i] = b.v;
    }
    if constexpr (Motion::kHasFormula) {
      if (kicked_count > 0) apply_multiplicative_kicks(motion, kicked, kicked_count);
      for (int k = 0; k < kicked_count; ++k) {
        vs.at[kicked_lane[k]] = kicked[k]->branch.v;
        kicks.at[kicked_lane[k]] = kicked[k]->branch.time_to_kick;
      }
    }
    v = simd::load<Real>(vs.at);
    time_to_impulse = simd::load<Real>(times_to_impulse.at);
    if constexpr (Motion::kHasKicks) time_to_kick = simd::load<Real>(kicks.at);
    // Impulses and noise kicks end the state of rest of the mass on a wall.
    if constexpr (Motion::kHasRest)
      time_to_rest = simd::select(now, simd::all_lanes_equal_to<Real>(-1.0), time_to_rest);
  }

  FPKCHECK_INLINE Flight make_flight(const SimulatedOscillator& of_flights,
                                     [[maybe_unused]] const Real& until_event,
                                     [[maybe_unused]] const Mask& active) {
    if constexpr (Motion::kHasFormula) {
      const Mask moving = active & (time_to_rest < 0.0);
      return Flight(of_flights, {y, v}, motion.end_time - remaining, motion.step, until_event,
                    moving, integrator);
    } else {
      return Flight(of_flights, {y, v});
    }
  }

  FPKCHECK_INLINE void advance_trajectory_streams() {
    // A local copy of the oscillator allows optimisation, since the compiler must assume that
    // stores of sums change the original oscillator.
    const SimulatedOscillator of_flights = oscillator;
    load_branch_states();
    for (;;) {
      const Mask active = remaining > 0.0;
      if (!simd::any_mask_lane_set(active)) break;
      // The loop ends because every iteration advances the time of a SIMD lane, ends at a wall, or
      // rejects the step of a FormulaFlight. After apply_impacts() at a wall the velocity points
      // inwards or the mass rests, so that the next iteration advances the time. After a rejected
      // integration step the next integration step is shorter.
      apply_impacts(active);
      Real span = simd::lanewise_min(time_to_impulse, remaining);
      if constexpr (Motion::kHasKicks) span = simd::lanewise_min(span, time_to_kick);
      Flight flight = make_flight(of_flights, span, active);
      Mask in_contact = active, free = active;
      if constexpr (Motion::kHasRest) {
        in_contact = time_to_rest >= 0.0;
        if (simd::any_mask_lane_set(in_contact)) flight.hold_mass_at_initial_position(in_contact);
        free = active & (time_to_rest < 0.0);
        span = simd::select(free, simd::lanewise_min(span, flight.max_flight_duration(motion.step)),
                            span);
      } else {
        span = simd::lanewise_min(flight.max_flight_duration(motion.step), span);
      }
      span = simd::select_or_zero(active, span);
      PhaseState<Real> end = flight.state_at_time(span);
      if constexpr (Motion::kHasAnyWalls) {
        end_flight_at_first_wall(flight, span, end, free);
      } else {
        end_flight_at_single_wall(flight, span, end);
      }
      if (motion.records) {
        flights = flights + simd::select_or_zero(active, simd::all_lanes_equal_to<Real>(1.0));
        record_trajectory_samples(flight, span, in_contact);
      }
      remaining = remaining - span;
      time_to_impulse = time_to_impulse - span;
      if constexpr (Motion::kHasKicks) time_to_kick = time_to_kick - span;
      if constexpr (Motion::kHasRest) {
        time_to_rest =
            simd::select(in_contact, simd::lanewise_max(time_to_rest - span, Real{}), time_to_rest);
      }
      // At a grazing turning point rounding may place y slightly behind a wall.
      y = end.y;
      if (!Motion::kHasAnyWalls || oscillator.left.exists) y = simd::lanewise_max(y, Real{});
      if (Motion::kHasAnyWalls && oscillator.right.exists)
        y = simd::lanewise_min(y, simd::all_lanes_equal_to<Real>(oscillator.right.position));
      v = end.v;
      apply_impulses_and_kicks(active);
    }
    store_branch_states();
    if (motion.records) add_lane_sums_to_streams();
  }
};

/// Orders of the Taylor polynomials; for the short flights between noise kicks order 8 suffices.
inline constexpr int kOrderOfFlights = 12, kOrderBetweenKicks = 8;

template <int W>
void advance_one_stream_per_lane(const StreamMotionParameters& motion,
                                 TrajectoryStream* const* streams) {
  if (motion.oscillator.is_duffing_at_wall()) {
    SimdLaneStates<W, DuffingMotion>(motion, streams).advance_trajectory_streams();
  } else if (motion.oscillator.kind == SimulatedOscillator::Kind::formula) {
    SimdLaneStates<W, FormulaMotion>(motion, streams).advance_trajectory_streams();
  } else if (motion.kicks.is_acting()) {
    SimdLaneStates<W, PolynomialMotion<kOrderBetweenKicks>>(motion, streams)
        .advance_trajectory_streams();
  } else {
    SimdLaneStates<W, PolynomialMotion<kOrderOfFlights>>(motion, streams)
        .advance_trajectory_streams();
  }
}

template <int... Widths>
void advance_lane_group(const StreamMotionParameters& motion, TrajectoryStream* const* streams,
                        int stream_count) {
  ((stream_count == Widths ? advance_one_stream_per_lane<Widths>(motion, streams) : void()), ...);
}

}  // namespace
}  // namespace fpkcheck::mcs
