#pragma once

#include "mcs/motion/general_events.hpp"
#include "mcs/motion/general_flight.hpp"
#include "mcs/motion/sample_lanes.hpp"

// Included by files that are compiled for different instruction sets, as motion/advance_simd.hpp.
namespace fpkcheck::mcs {
namespace {

/// State and sums of several streams, one per SIMD lane.
template <int W, int kOrder>
struct GeneralLanes {
  using Real = typename simd::LanesOf<W>::Real;
  using Mask = decltype(Real{} < Real{});
  using Flight = GeneralFlight<Real, kOrder>;
  template <class Number>
  using Array = LaneArray<Number, W>;

  const GeneralMotion& motion;
  Stream* const* streams;
  double* cells[W];  // of the histogram of each stream
  Real y{}, v{}, until_impulse{}, until_kick{}, until_sample{}, remaining{}, bouncing{};
  Real weight{};  // of the branches
  Real powers[kPowers.size()]{};
  Real y5{}, y6{};
  Real samples{}, impacts{}, flights{};
  Real left_speed{}, left_energy{}, right_speed{}, right_energy{};
  Real rest_left{}, rest_right{};

  FPKCHECK_INLINE GeneralLanes(const GeneralMotion& m, Stream* const* s) : motion(m), streams(s) {
    for (int i = 0; i < W; ++i) cells[i] = streams[i]->record.histogram.weights().data();
  }

  FPKCHECK_INLINE void load_branches() {
    Array<double> a[8];
    for (int i = 0; i < W; ++i) {
      const Branch& b = streams[i]->branch;
      const GeneralBranch& g = streams[i]->general;
      a[0].at[i] = b.y;
      a[1].at[i] = b.v;
      a[2].at[i] = b.until_impulse;
      a[3].at[i] = b.until_sample;
      a[4].at[i] = b.remaining;
      a[5].at[i] = g.until_kick;
      a[6].at[i] = g.bouncing;
      a[7].at[i] = weight_of(motion, *streams[i]);
    }
    y = simd::load<Real>(a[0].at);
    v = simd::load<Real>(a[1].at);
    until_impulse = simd::load<Real>(a[2].at);
    until_sample = simd::load<Real>(a[3].at);
    remaining = simd::load<Real>(a[4].at);
    until_kick = simd::load<Real>(a[5].at);
    bouncing = simd::load<Real>(a[6].at);
    weight = simd::load<Real>(a[7].at);
  }
  FPKCHECK_INLINE void store_branches() const {
    for (int i = 0; i < W; ++i) {
      Branch& b = streams[i]->branch;
      b.y = simd::lane(y, i);
      b.v = simd::lane(v, i);
      b.until_impulse = simd::lane(until_impulse, i);
      b.until_sample = simd::lane(until_sample, i);
      b.remaining = simd::lane(remaining, i);
      streams[i]->general.until_kick = simd::lane(until_kick, i);
      streams[i]->general.bouncing = simd::lane(bouncing, i);
    }
  }

  FPKCHECK_INLINE void store_sums() const {
    for (int i = 0; i < W; ++i) {
      StreamRecord& record = streams[i]->record;
      for (std::size_t p = 0; p < kPowers.size(); ++p) record.powers[p] += simd::lane(powers[p], i);
      record.samples += simd::lane(samples, i);
      record.impacts += simd::lane(impacts, i);
      record.impact_speed += simd::lane(left_speed, i);
      record.impact_energy += simd::lane(left_energy, i);
      record.flights += static_cast<std::uint64_t>(simd::lane(flights, i));
      GeneralSums& sums = *record.general;
      sums.y5 += simd::lane(y5, i);
      sums.y6 += simd::lane(y6, i);
      sums.right_speed += simd::lane(right_speed, i);
      sums.right_energy += simd::lane(right_energy, i);
      sums.rest_left += simd::lane(rest_left, i);
      sums.rest_right += simd::lane(rest_right, i);
    }
  }

  /// Applies paper (2) at one wall.
  /// @param inwards 1 at the left wall, -1 at the right wall
  FPKCHECK_INLINE void rebound(const GeneralWall& wall, double inwards, const Mask& active,
                               Real& speed_sum, Real& energy_sum) {
    const double r = wall.restitution;
    const Real speed = -inwards * v;  // towards the wall
    Mask impact = active & (inwards * (y - wall.position) <= 0.0) & (bouncing < 0.0);
    // With a positive contact force the mass returns to the wall at any speed, and may stay.
    impact = impact & (wall.pressing > 0 ? speed >= 0.0 : speed > 0.0);
    if (!simd::any(impact)) return;
    if (motion.records) {
      const Real counted = simd::where(impact, weight);
      impacts = impacts + counted;
      speed_sum = speed_sum + counted * speed;
      energy_sum = energy_sum + counted * (speed * speed);
    }
    Real after = -r * v;
    if (wall.pressing > 0) {
      const Mask stays = impact & (speed < wall.slow);
      if (simd::any(stays)) {
        // Bounces at r, r^2, .. times the speed, each for 2 speed / contact_force; without end for
        // r = 1.
        constexpr double kForever = 1e300;
        const double times = r < 1 ? 2 * r / ((1 - r) * wall.pressing) : 0;
        const Real time = r < 1 ? speed * times : simd::all_lanes<Real>(kForever);
        bouncing = simd::select(stays, time, bouncing);
        after = simd::select(stays, Real{}, after);
        if (motion.records && r < 1) {
          const Real counted = simd::where(stays, weight);
          speed_sum = speed_sum + counted * (speed * (r / (1 - r)));
          energy_sum = energy_sum + counted * (speed * speed * (r * r / (1 - r * r)));
        }
      }
    }
    v = simd::select(impact, after, v);
  }

  FPKCHECK_INLINE void sample(const Flight& flight, const Real& span, const Mask& held) {
    const bool rests = !motion.kicks.present();
    for (;;) {
      const Mask due = until_sample < span;
      if (!simd::any(due)) break;
      const Real time = simd::where(due, until_sample);
      count(flight.at(time), due, due & held & (bouncing <= time), rests);
      until_sample =
          until_sample + simd::where(due, simd::all_lanes<Real>(motion.sampling_interval));
    }
    until_sample = until_sample - span;
  }

  // A lane without a sample takes part with the weight 0.
  FPKCHECK_INLINE void count(const BasicState<Real>& at, const Mask& due, const Mask& at_rest,
                             bool rests) {
    const Real counted = simd::where(due, weight);
    add_powers(at, counted, powers);
    const Real x = at.y, xx = x * x;
    y5 = y5 + counted * (xx * xx * x);
    y6 = y6 + counted * (xx * xx * xx);
    samples = samples + counted;
    Real into_bins = counted;
    if (rests && simd::any(at_rest)) {
      into_bins = simd::select(at_rest, Real{}, counted);
      const GeneralWall& right = motion.oscillator.right;
      const Real resting = simd::where(at_rest, weight);
      if (right.stands) {
        const Real there = simd::select(x > right.position / 2, resting, Real{});
        rest_right = rest_right + there;
        rest_left = rest_left + (resting - there);
      } else {
        rest_left = rest_left + resting;
      }
    }
    put_into_bins(*motion.y_bins, *motion.v_bins, between_walls(x), at.v, into_bins, streams,
                  cells);
  }

  // Rounding may put a sample at an impact slightly behind a wall.
  FPKCHECK_INLINE Real between_walls(const Real& x) const {
    Real between = x;
    if (motion.oscillator.right.stands) {
      const double last = motion.oscillator.right.position - motion.y_bins->hair();
      between = simd::smaller(between, simd::all_lanes<Real>(last));
    }
    if (motion.oscillator.left.stands) between = simd::larger(between, Real{});
    return between;
  }

  /// Adds the weight of each lane in `there` to the bin of y.
  FPKCHECK_INLINE void note(std::vector<double> StreamRecord::*of, const Real& at,
                            const Mask& there) {
    if (!simd::any(there)) return;
    for (int i = 0; i < W; ++i) {
      if (simd::lane(there, i) == 0) continue;
      (streams[i]->record.*of)[(*motion.y_bins)(simd::lane(at, i))] += simd::lane(weight, i);
    }
  }

  /// Ends the flight at the first impact in [0, span], if any. The velocity changes its sign at
  /// most once, so y at both ends and at the extreme determine the impacts. Signs at the ends alone
  /// miss two cases: the return to a wall with positive contact force, and an excursion behind a
  /// wall across a gap.
  FPKCHECK_INLINE void meet(const Flight& flight, Real& span, BasicState<Real>& end,
                            const Mask& free) {
    const GeneralOscillator& o = motion.oscillator;
    const Mask turned = free & (v * end.v < 0.0);
    Real turning{}, extreme = y;
    if (simd::any(turned)) {
      turning = flight.turning_time(span, end, turned);
      extreme = flight.at(turning).y;
    }
    const Mask none = turned & (v != v);
    const Mask low_turn = turned & (v < 0.0), high_turn = turned & (v > 0.0);
    Mask left_first = none, right_first = none, left = none, right = none;
    if (o.left.stands) {
      left_first = low_turn & (extreme < 0.0);
      left = free & (end.y < 0.0);
    }
    if (o.right.stands) {
      right_first = high_turn & (extreme > o.right.position);
      right = free & (end.y > o.right.position);
    }
    const Mask first = left_first | right_first;
    left = left_first | (left & (right_first == none));
    right = right_first | (right & (left_first == none));
    const Mask impact = left | right;
    if (simd::any(impact)) {
      const Real wall = simd::select(right, simd::all_lanes<Real>(o.right.position), Real{});
      const Real inside =
          simd::select(right, simd::all_lanes<Real>(-1.0), simd::all_lanes<Real>(1.0));
      const Mask after_turn = turned & (first == none);
      const Real low = simd::select(after_turn, turning, Real{});
      const Real high = simd::select(first, turning, span);
      // Initial guess from the parabola about the extreme, or from the chord without an extreme.
      const Real from_extreme = extreme - wall;
      const Real of_first =
          1.0 - simd::square_root(simd::larger(from_extreme / (extreme - y), Real{}));
      const Real of_last =
          simd::square_root(simd::larger(from_extreme / (extreme - end.y), Real{}));
      const Real of_chord = (y - wall) / (y - end.y);
      const Real part = simd::select(first, of_first, simd::select(after_turn, of_last, of_chord));
      const Real guess = simd::smaller(simd::larger(low + (high - low) * part, low), high);
      span = simd::select(impact, flight.impact_time(wall, inside, low, high, guess, impact), span);
      const BasicState<Real> at_wall = flight.at(span);
      end.v = simd::select(impact, at_wall.v, end.v);
      end.y = simd::select(impact, wall, end.y);
    }
    if (!motion.records) return;
    note(&StreamRecord::peaks, extreme, high_turn & (right_first == none));
    note(&StreamRecord::troughs, extreme, low_turn & (left_first == none));
    if (o.right.stands) {
      note(&StreamRecord::peaks, simd::all_lanes<Real>(o.right.position - motion.y_bins->hair()),
           right);
    }
  }

  /// Applies impulses, kicks and ends of branches, lane by lane.
  FPKCHECK_INLINE void single_events(const Mask& active) {
    const Mask impulse_now = active & (until_impulse <= 0.0);
    if (motion.records && motion.splitting) {  // kicks and splitting exclude each other
      if (!simd::any(impulse_now) && !simd::any(active & (remaining <= 0.0))) return;
      store_branches();
      for (int i = 0; i < W; ++i) {
        Stream& stream = *streams[i];
        if (simd::lane(impulse_now, i) != 0) receive_general_impulse(motion, stream);
        while (stream.branch.remaining <= 0 && !stream.whole()) follow_next(stream);
      }
      load_branches();
      return;
    }
    const Mask kick_now = active & (until_kick <= 0.0);
    const Mask now = impulse_now | kick_now;
    if (!simd::any(now)) return;
    Array<double> a[5];
    simd::store(y, a[0].at);
    simd::store(v, a[1].at);
    simd::store(until_impulse, a[2].at);
    simd::store(until_kick, a[3].at);
    simd::store(bouncing, a[4].at);
    for (int i = 0; i < W; ++i) {
      if (simd::lane(now, i) == 0) continue;
      Stream& stream = *streams[i];
      Branch& b = stream.branch;
      b.y = a[0].at[i];
      b.v = a[1].at[i];
      b.until_impulse = a[2].at[i];
      stream.general.until_kick = a[3].at[i];
      stream.general.bouncing = a[4].at[i];
      if (simd::lane(impulse_now, i) != 0) receive_general_impulse(motion, stream);
      if (simd::lane(kick_now, i) != 0) receive_kick(motion, stream);
      a[1].at[i] = b.v;
      a[2].at[i] = b.until_impulse;
      a[3].at[i] = stream.general.until_kick;
      a[4].at[i] = stream.general.bouncing;
    }
    v = simd::load<Real>(a[1].at);
    until_impulse = simd::load<Real>(a[2].at);
    until_kick = simd::load<Real>(a[3].at);
    bouncing = simd::load<Real>(a[4].at);
  }

  FPKCHECK_INLINE void move() {
    const GeneralOscillator& o = motion.oscillator;
    load_branches();
    for (;;) {
      const Mask active = remaining > 0.0;
      if (!simd::any(active)) break;
      // Every iteration advances the time of a lane or ends at a wall. There the velocity points
      // inwards or the lane is at rest, so the next iteration advances the time.
      if (o.left.stands) rebound(o.left, 1, active, left_speed, left_energy);
      if (o.right.stands) rebound(o.right, -1, active, right_speed, right_energy);
      const Mask held = bouncing >= 0.0;
      Flight flight(o, {y, v});
      if (simd::any(held)) flight.hold(held);
      Real span = simd::smaller(simd::smaller(until_impulse, until_kick), remaining);
      const Mask free = active & (bouncing < 0.0);
      span = simd::select(free, simd::smaller(span, flight.reach(motion.step)), span);
      span = simd::where(active, span);
      BasicState<Real> end = flight.at(span);
      meet(flight, span, end, free);
      if (motion.records) {
        flights = flights + simd::where(active, simd::all_lanes<Real>(1.0));
        sample(flight, span, held);
      }
      remaining = remaining - span;
      until_impulse = until_impulse - span;
      until_kick = until_kick - span;
      bouncing = simd::select(held, simd::larger(bouncing - span, Real{}), bouncing);
      // At a grazing turn rounding may put y slightly behind a wall.
      y = end.y;
      if (o.left.stands) y = simd::larger(y, Real{});
      if (o.right.stands) y = simd::smaller(y, simd::all_lanes<Real>(o.right.position));
      v = end.v;
      single_events(active);
    }
    store_branches();
    if (motion.records) store_sums();
  }
};

/// Between kicks flights are short: a lower order is as exact.
inline constexpr int kOrderOfFlights = 12, kOrderBetweenKicks = 8;

template <int W>
void move_general_lanes(const GeneralMotion& motion, Stream* const* streams) {
  if (motion.kicks.present()) {
    GeneralLanes<W, kOrderBetweenKicks>(motion, streams).move();
  } else {
    GeneralLanes<W, kOrderOfFlights>(motion, streams).move();
  }
}

/// Calls advance_general_in_lanes() for `width`, which must be one of Widths.
template <int... Widths>
void move_general_any_of(const GeneralMotion& motion, Stream* const* streams, int width) {
  ((width == Widths ? move_general_lanes<Widths>(motion, streams) : void()), ...);
}

}  // namespace
}  // namespace fpkcheck::mcs
