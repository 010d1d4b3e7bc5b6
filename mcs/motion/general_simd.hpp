#pragma once

#include "mcs/motion/general_events.hpp"
#include "mcs/motion/general_flight.hpp"
#include "mcs/motion/sample_simd.hpp"

// Included by files that are compiled for different instruction sets, as motion/advance_simd.hpp.
namespace fpkcheck::mcs {
namespace {

/// State and sums of several streams, one per SIMD lane.
template <int W, int kOrder>
struct GeneralLaneState {
  using Real = typename simd::VectorTypes<W>::Real;
  using Mask = decltype(Real{} < Real{});
  using Flight = GeneralFlight<Real, kOrder>;
  template <class Number>
  using Array = LaneArray<Number, W>;

  const GeneralMotionParameters& motion;
  Stream* const* streams;
  double* cells[W];  // of the histogram of each stream
  Real y{}, v{}, until_impulse{}, until_kick{}, until_sample{}, remaining{}, time_to_rest{};
  Real weight{};  // of the branches
  Real powers[kPowers.size()]{};
  Real y5{}, y6{};
  Real samples{}, impacts{}, flights{};
  Real left_speed{}, left_energy{}, right_speed{}, right_energy{};
  Real rest_left{}, rest_right{};

  FPKCHECK_INLINE GeneralLaneState(const GeneralMotionParameters& m, Stream* const* s)
      : motion(m), streams(s) {
    for (int i = 0; i < W; ++i) cells[i] = streams[i]->record.histogram.weights().data();
  }

  FPKCHECK_INLINE void load_branches() {
    Array<double> a[8];
    for (int i = 0; i < W; ++i) {
      const Branch& b = streams[i]->branch;
      a[0].at[i] = b.y;
      a[1].at[i] = b.v;
      a[2].at[i] = b.until_impulse;
      a[3].at[i] = b.until_sample;
      a[4].at[i] = b.remaining;
      a[5].at[i] = b.until_kick;
      a[6].at[i] = b.time_to_rest;
      a[7].at[i] = branch_weight(motion, *streams[i]);
    }
    y = simd::load<Real>(a[0].at);
    v = simd::load<Real>(a[1].at);
    until_impulse = simd::load<Real>(a[2].at);
    until_sample = simd::load<Real>(a[3].at);
    remaining = simd::load<Real>(a[4].at);
    until_kick = simd::load<Real>(a[5].at);
    time_to_rest = simd::load<Real>(a[6].at);
    weight = simd::load<Real>(a[7].at);
  }
  FPKCHECK_INLINE void store_branches() const {
    for (int i = 0; i < W; ++i) {
      Branch& b = streams[i]->branch;
      b.y = simd::lane_value(y, i);
      b.v = simd::lane_value(v, i);
      b.until_impulse = simd::lane_value(until_impulse, i);
      b.until_sample = simd::lane_value(until_sample, i);
      b.remaining = simd::lane_value(remaining, i);
      b.until_kick = simd::lane_value(until_kick, i);
      b.time_to_rest = simd::lane_value(time_to_rest, i);
    }
  }

  FPKCHECK_INLINE void store_sums() const {
    for (int i = 0; i < W; ++i) {
      StreamRecord& record = streams[i]->record;
      for (std::size_t p = 0; p < kPowers.size(); ++p)
        record.powers[p] += simd::lane_value(powers[p], i);
      record.samples += simd::lane_value(samples, i);
      record.impacts += simd::lane_value(impacts, i);
      record.left_speed += simd::lane_value(left_speed, i);
      record.left_energy += simd::lane_value(left_energy, i);
      record.flights += static_cast<std::uint64_t>(simd::lane_value(flights, i));
      record.y5 += simd::lane_value(y5, i);
      record.y6 += simd::lane_value(y6, i);
      record.right_speed += simd::lane_value(right_speed, i);
      record.right_energy += simd::lane_value(right_energy, i);
      record.rest_left += simd::lane_value(rest_left, i);
      record.rest_right += simd::lane_value(rest_right, i);
    }
  }

  /// Applies paper (2) at one wall.
  /// @param inwards 1 at the left wall, -1 at the right wall
  FPKCHECK_INLINE void apply_impact(const GeneralWall& wall, double inwards, const Mask& active,
                                    Real& speed_sum, Real& energy_sum) {
    const double r = wall.restitution;
    const Real speed = -inwards * v;  // towards the wall
    Mask impact = active & (inwards * (y - wall.position) <= 0.0) & (time_to_rest < 0.0);
    // With a positive contact force the mass returns to the wall at any speed, and may stay.
    impact = impact & (wall.contact_force > 0 ? speed >= 0.0 : speed > 0.0);
    if (!simd::any_lane_set(impact)) return;
    if (motion.records) {
      const Real counted_weight = simd::select_or_zero(impact, weight);
      impacts = impacts + counted_weight;
      speed_sum = speed_sum + counted_weight * speed;
      energy_sum = energy_sum + counted_weight * (speed * speed);
    }
    Real after = -r * v;
    if (wall.contact_force > 0) {
      const Mask stays = impact & (speed < wall.rest_speed);
      if (simd::any_lane_set(stays)) {
        // The bounces start at r, r^2, .. times the speed, and each takes 2 (its speed) /
        // contact_force. For r = 1 the bounces never end.
        constexpr double kNoEnd = 1e300;
        const double times = r < 1 ? 2 * r / ((1 - r) * wall.contact_force) : 0;
        const Real time = r < 1 ? speed * times : simd::broadcast<Real>(kNoEnd);
        time_to_rest = simd::select(stays, time, time_to_rest);
        after = simd::select(stays, Real{}, after);
        if (motion.records && r < 1) {
          const Real counted_weight = simd::select_or_zero(stays, weight);
          speed_sum = speed_sum + counted_weight * (speed * (r / (1 - r)));
          energy_sum = energy_sum + counted_weight * (speed * speed * (r * r / (1 - r * r)));
        }
      }
    }
    v = simd::select(impact, after, v);
  }

  FPKCHECK_INLINE void record_samples(const Flight& flight, const Real& span,
                                      const Mask& in_contact) {
    const bool rests = !motion.kicks.is_present();
    for (;;) {
      const Mask due = until_sample < span;
      if (!simd::any_lane_set(due)) break;
      const Real time = simd::select_or_zero(due, until_sample);
      count_sample(flight.state_at_time(time), due, due & in_contact & (time_to_rest <= time),
                   rests);
      until_sample =
          until_sample + simd::select_or_zero(due, simd::broadcast<Real>(motion.sampling_interval));
    }
    until_sample = until_sample - span;
  }

  // A lane without a due sample is counted with the weight 0.
  FPKCHECK_INLINE void count_sample(const BasicState<Real>& at, const Mask& due,
                                    const Mask& at_rest, bool rests) {
    const Real counted_weight = simd::select_or_zero(due, weight);
    add_powers(at, counted_weight, powers);
    const Real x = at.y, xx = x * x;
    y5 = y5 + counted_weight * (xx * xx * x);
    y6 = y6 + counted_weight * (xx * xx * xx);
    samples = samples + counted_weight;
    Real into_bins = counted_weight;
    if (rests && simd::any_lane_set(at_rest)) {
      into_bins = simd::select(at_rest, Real{}, counted_weight);
      const GeneralWall& right = motion.oscillator.right;
      const Real resting = simd::select_or_zero(at_rest, weight);
      if (right.exists) {
        const Real there = simd::select(x > right.position / 2, resting, Real{});
        rest_right = rest_right + there;
        rest_left = rest_left + (resting - there);
      } else {
        rest_left = rest_left + resting;
      }
    }
    add_to_histogram(*motion.y_bins, *motion.v_bins, clamp_between_walls(x), at.v, into_bins,
                     streams, cells);
  }

  // Rounding may put a sample at an impact slightly behind a wall.
  FPKCHECK_INLINE Real clamp_between_walls(const Real& x) const {
    Real between = x;
    if (motion.oscillator.right.exists) {
      const double last = motion.oscillator.right.position - motion.y_bins->edge_epsilon();
      between = simd::lanewise_min(between, simd::broadcast<Real>(last));
    }
    if (motion.oscillator.left.exists) between = simd::lanewise_max(between, Real{});
    return between;
  }

  /// Adds the weight of each lane in `there` to the bin of y.
  FPKCHECK_INLINE void add_to_bins(std::vector<double> StreamRecord::*of, const Real& at,
                                   const Mask& there) {
    if (!simd::any_lane_set(there)) return;
    for (int i = 0; i < W; ++i) {
      if (simd::lane_value(there, i) == 0) continue;
      (streams[i]->record.*of)[(*motion.y_bins)(simd::lane_value(at, i))] +=
          simd::lane_value(weight, i);
    }
  }

  /// Ends the flight at the first impact in [0, span], if any. The velocity changes its sign at
  /// most once, so y at both ends and at the extreme determine the impacts. Signs at the ends alone
  /// miss two cases: the return to a wall with positive contact force, and an excursion behind a
  /// wall across a gap.
  FPKCHECK_INLINE void end_at_impact(const Flight& flight, Real& span, BasicState<Real>& end,
                                     const Mask& free) {
    const GeneralOscillator& o = motion.oscillator;
    const Mask turned = free & (v * end.v < 0.0);
    Real turning{}, extreme = y;
    if (simd::any_lane_set(turned)) {
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
    if (simd::any_lane_set(impact)) {
      const Real wall = simd::select(right, simd::broadcast<Real>(o.right.position), Real{});
      const Real inside =
          simd::select(right, simd::broadcast<Real>(-1.0), simd::broadcast<Real>(1.0));
      const Mask after_turn = turned & (first == none);
      const Real low = simd::select(after_turn, turning, Real{});
      const Real high = simd::select(first, turning, span);
      // Initial guess from the parabola about the extreme, or from the chord without an extreme.
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
      const BasicState<Real> at_wall = flight.state_at_time(span);
      end.v = simd::select(impact, at_wall.v, end.v);
      end.y = simd::select(impact, wall, end.y);
    }
    if (!motion.records) return;
    add_to_bins(&StreamRecord::peaks, extreme, high_turn & (right_first == none));
    add_to_bins(&StreamRecord::troughs, extreme, low_turn & (left_first == none));
    if (o.right.exists) {
      add_to_bins(&StreamRecord::peaks,
                  simd::broadcast<Real>(o.right.position - motion.y_bins->edge_epsilon()), right);
    }
  }

  /// Applies impulses, kicks and ends of branches, lane by lane.
  FPKCHECK_INLINE void apply_lane_events(const Mask& active) {
    const Mask impulse_now = active & (until_impulse <= 0.0);
    if (motion.records && motion.splitting) {  // kicks and splitting exclude each other
      if (!simd::any_lane_set(impulse_now) && !simd::any_lane_set(active & (remaining <= 0.0)))
        return;
      store_branches();
      for (int i = 0; i < W; ++i) {
        Stream& stream = *streams[i];
        if (simd::lane_value(impulse_now, i) != 0) apply_general_impulse(motion, stream);
        while (stream.branch.remaining <= 0 && !stream.is_on_main_branch())
          resume_next_branch(stream);
      }
      load_branches();
      return;
    }
    const Mask kick_now = active & (until_kick <= 0.0);
    const Mask now = impulse_now | kick_now;
    if (!simd::any_lane_set(now)) return;
    Array<double> a[5];
    simd::store(y, a[0].at);
    simd::store(v, a[1].at);
    simd::store(until_impulse, a[2].at);
    simd::store(until_kick, a[3].at);
    simd::store(time_to_rest, a[4].at);
    for (int i = 0; i < W; ++i) {
      if (simd::lane_value(now, i) == 0) continue;
      Stream& stream = *streams[i];
      Branch& b = stream.branch;
      b.y = a[0].at[i];
      b.v = a[1].at[i];
      b.until_impulse = a[2].at[i];
      b.until_kick = a[3].at[i];
      b.time_to_rest = a[4].at[i];
      if (simd::lane_value(impulse_now, i) != 0) apply_general_impulse(motion, stream);
      if (simd::lane_value(kick_now, i) != 0) apply_kick(motion, stream);
      a[1].at[i] = b.v;
      a[2].at[i] = b.until_impulse;
      a[3].at[i] = b.until_kick;
      a[4].at[i] = b.time_to_rest;
    }
    v = simd::load<Real>(a[1].at);
    until_impulse = simd::load<Real>(a[2].at);
    until_kick = simd::load<Real>(a[3].at);
    time_to_rest = simd::load<Real>(a[4].at);
  }

  FPKCHECK_INLINE void advance_streams() {
    const GeneralOscillator& o = motion.oscillator;
    load_branches();
    for (;;) {
      const Mask active = remaining > 0.0;
      if (!simd::any_lane_set(active)) break;
      // Every iteration advances the time of a lane or ends at a wall. There the velocity points
      // inwards or the lane is at rest, so the next iteration advances the time.
      if (o.left.exists) apply_impact(o.left, 1, active, left_speed, left_energy);
      if (o.right.exists) apply_impact(o.right, -1, active, right_speed, right_energy);
      const Mask in_contact = time_to_rest >= 0.0;
      Flight flight(o, {y, v});
      if (simd::any_lane_set(in_contact)) flight.hold_position(in_contact);
      Real span = simd::lanewise_min(simd::lanewise_min(until_impulse, until_kick), remaining);
      const Mask free = active & (time_to_rest < 0.0);
      span = simd::select(free, simd::lanewise_min(span, flight.max_step(motion.step)), span);
      span = simd::select_or_zero(active, span);
      BasicState<Real> end = flight.state_at_time(span);
      end_at_impact(flight, span, end, free);
      if (motion.records) {
        flights = flights + simd::select_or_zero(active, simd::broadcast<Real>(1.0));
        record_samples(flight, span, in_contact);
      }
      remaining = remaining - span;
      until_impulse = until_impulse - span;
      until_kick = until_kick - span;
      time_to_rest =
          simd::select(in_contact, simd::lanewise_max(time_to_rest - span, Real{}), time_to_rest);
      // At a grazing turn rounding may put y slightly behind a wall.
      y = end.y;
      if (o.left.exists) y = simd::lanewise_max(y, Real{});
      if (o.right.exists) y = simd::lanewise_min(y, simd::broadcast<Real>(o.right.position));
      v = end.v;
      apply_lane_events(active);
    }
    store_branches();
    if (motion.records) store_sums();
  }
};

/// Orders of the Taylor polynomials. Flights between kicks are short, so that a lower order
/// suffices.
inline constexpr int kOrderOfFlights = 12, kOrderBetweenKicks = 8;

template <int W>
void advance_in_lanes(const GeneralMotionParameters& motion, Stream* const* streams) {
  if (motion.kicks.is_present()) {
    GeneralLaneState<W, kOrderBetweenKicks>(motion, streams).advance_streams();
  } else {
    GeneralLaneState<W, kOrderOfFlights>(motion, streams).advance_streams();
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
