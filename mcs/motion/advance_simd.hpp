#pragma once

#include "mcs/deposit/deposit_simd.hpp"
#include "mcs/motion/advance.hpp"
#include "mcs/motion/flight.hpp"
#include "mcs/motion/general_simd.hpp"
#include "mcs/motion/sample_simd.hpp"
#include "numerics/simd/simd.hpp"

// Included by files that are compiled for different instruction sets (InstructionSet). Everything
// here is inlined or has internal linkage. The linker therefore cannot merge two copies of a
// function and keep the copy with instructions that the processor lacks.

namespace fpkcheck::mcs {
namespace {

/// Applies one impulse, paper (3), and draws the next impulse.
template <bool kRecords>
void apply_impulse(const MotionParameters& motion, Stream& stream) {
  Branch& b = stream.branch;
  const double before = b.v;
  b.v += b.amplitude;
  if constexpr (kRecords) {
    const double counted_weight = motion.splitting ? motion.splitting->branch_weight(b) : 1.0;
    const auto turned = [&](double from, double to) { return from > 0 && to < 0; };
    if (turned(before, b.v)) stream.record.peaks[(*motion.y_bins)(b.y)] += counted_weight;
    if (turned(b.v, before) && b.y > 0)
      stream.record.troughs[(*motion.y_bins)(b.y)] += counted_weight;
    ++(stream.is_on_main_branch() ? stream.record.impulses : stream.record.branch_impulses);
    stream.record.work +=
        counted_weight * ((b.amplitude - motion.shift) * before + b.amplitude * b.amplitude / 2);
    if (motion.deposit) {
      std::array<double, 3>& drawn = stream.record.deposit.impulses;
      drawn[0] += counted_weight;
      drawn[1] += counted_weight * b.amplitude;
      drawn[2] += counted_weight * (b.amplitude * b.amplitude);
    }
  }
  const Impulse next = stream.source.next_impulse();
  b.until_impulse = next.waiting;
  b.amplitude = next.amplitude;
  if (kRecords && motion.splitting) motion.splitting->update_after_impulse(stream);
}

/// State and sums of several streams, one per SIMD lane.
template <int W>
struct LaneState {
  using Real = typename simd::VectorTypes<W>::Real;
  using Mask = decltype(Real{} < Real{});
  template <class Number>
  using Array = LaneArray<Number, W>;

  const MotionParameters& motion;
  Stream* const* streams;
  double* cells[W];  // of the histogram of each stream
  Real y{}, v{}, until_impulse{}, until_sample{}, remaining{}, weight{};
  Real powers[kPowers.size()]{};
  Real samples{}, impacts{}, impact_speed{}, impact_energy{}, flights{};
  Real beyond_wall{};  // y of the flight's polynomial at the next impact: 0 up to rounding

  FPKCHECK_INLINE LaneState(const MotionParameters& m, Stream* const* s) : motion(m), streams(s) {
    for (int i = 0; i < W; ++i) cells[i] = streams[i]->record.histogram.weights().data();
  }

  // Load the state of the lanes from the branches of the streams, and store the state there.
  FPKCHECK_INLINE void load_branches() {
    Array<double> a[6];
    for (int i = 0; i < W; ++i) {
      const Branch& b = streams[i]->branch;
      a[0].at[i] = b.y;
      a[1].at[i] = b.v;
      a[2].at[i] = b.until_impulse;
      a[3].at[i] = b.until_sample;
      a[4].at[i] = b.remaining;
      a[5].at[i] = motion.splitting ? motion.splitting->branch_weight(b) : 1.0;
    }
    y = simd::load<Real>(a[0].at);
    v = simd::load<Real>(a[1].at);
    until_impulse = simd::load<Real>(a[2].at);
    until_sample = simd::load<Real>(a[3].at);
    remaining = simd::load<Real>(a[4].at);
    weight = simd::load<Real>(a[5].at);
  }
  FPKCHECK_INLINE void store_branch_of_lane(int lane) const {
    Branch& b = streams[lane]->branch;
    b.y = simd::lane_value(y, lane);
    b.v = simd::lane_value(v, lane);
    b.until_impulse = simd::lane_value(until_impulse, lane);
    b.until_sample = simd::lane_value(until_sample, lane);
    b.remaining = simd::lane_value(remaining, lane);
  }

  FPKCHECK_INLINE void store_sums() const {
    for (int i = 0; i < W; ++i) {
      StreamRecord& record = streams[i]->record;
      for (std::size_t p = 0; p < kPowers.size(); ++p)
        record.powers[p] += simd::lane_value(powers[p], i);
      record.samples += simd::lane_value(samples, i);
      record.impacts += simd::lane_value(impacts, i);
      record.left_speed += simd::lane_value(impact_speed, i);
      record.left_energy += simd::lane_value(impact_energy, i);
      record.flights += static_cast<std::uint64_t>(simd::lane_value(flights, i));
    }
  }

  /// Applies paper (2), also where an impulse pushes a resting oscillator into the wall.
  template <bool kRecords>
  FPKCHECK_INLINE void apply_impact(const Mask& active) {
    const Mask impact = active & (y <= 0.0) & (v < 0.0);
    if constexpr (kRecords) {
      const Real counted_weight = simd::select_or_zero(impact, weight);
      impacts = impacts + counted_weight;
      impact_speed = impact_speed - counted_weight * v;
      impact_energy = impact_energy + counted_weight * (v * v);
    }
    const Real after = simd::select(impact, -motion.oscillator.restitution * v, v);
    if (kRecords && motion.deposit && simd::any_lane_set(impact)) {
      for (int i = 0; i < W; ++i) {
        if (simd::lane_value(impact, i) == 0) continue;
        deposit_impact(*motion.deposit, streams[i]->record.deposit,
                       simd::lane_value(beyond_wall, i), simd::lane_value(v, i),
                       simd::lane_value(after, i), simd::lane_value(weight, i));
      }
      beyond_wall = simd::select(impact, Real{}, beyond_wall);
    }
    v = after;
  }

  FPKCHECK_INLINE void record_samples(const BasicFlight<Real>& flight, const Real& span) {
    for (;;) {
      const Mask due = until_sample < span;
      if (!simd::any_lane_set(due)) break;
      const Real time = simd::select_or_zero(due, until_sample);
      const BasicState<Real> at = flight.state_at_time(time);
      count_sample(at, simd::select_or_zero(due, weight));
      if (motion.deposit) deposit_due_samples(at, flight.polynomial_acceleration(time), due);
      until_sample =
          until_sample + simd::select_or_zero(due, simd::broadcast<Real>(motion.sampling_interval));
    }
    until_sample = until_sample - span;
  }

  // Deposits one sample after another: here the SIMD lanes hold the splines of a single sample.
  FPKCHECK_INLINE void deposit_due_samples(const BasicState<Real>& at, const Real& acceleration,
                                           const Mask& due) const {
    Array<double> ys, vs, as;
    simd::store(simd::lanewise_max(at.y, Real{}), ys.at);
    simd::store(at.v, vs.at);
    simd::store(acceleration, as.at);
#pragma GCC unroll 1
    for (int i = 0; i < W; ++i) {
      if (simd::lane_value(due, i) == 0) continue;
      deposit_sample(*motion.deposit, streams[i]->record.deposit, ys.at[i], vs.at[i], as.at[i],
                     simd::lane_value(weight, i));
    }
  }

  // A lane without a due sample is counted with the weight 0.
  FPKCHECK_INLINE void count_sample(const BasicState<Real>& at, const Real& counted_weight) {
    add_powers(at, counted_weight, powers);
    samples = samples + counted_weight;
    // Rounding may put a sample at an impact slightly behind the wall.
    const Real in_front = simd::lanewise_max(at.y, Real{});
    add_to_histogram(*motion.y_bins, *motion.v_bins, in_front, at.v, counted_weight, streams,
                     cells);
  }

  // Counts the maxima of y, at which the velocity changes its sign during a flight.
  FPKCHECK_INLINE void count_peaks(const BasicFlight<Real>& flight, const Real& span,
                                   const BasicState<Real>& end) {
    const Mask peak = (v > 0.0) & (end.v < 0.0);
    if (!simd::any_lane_set(peak)) return;
    const Real height = flight.state_at_time(flight.peak_time(span, end)).y;
    for (int i = 0; i < W; ++i) {
      if (simd::lane_value(v, i) > 0 && simd::lane_value(end.v, i) < 0) {
        streams[i]->record.peaks[(*motion.y_bins)(simd::lane_value(height, i))] +=
            simd::lane_value(weight, i);
      }
    }
  }

  /// Applies impulses and ends of branches, lane by lane.
  template <bool kRecords>
  FPKCHECK_INLINE void apply_lane_events(const Mask& active) {
    const Mask impulse_now = active & (until_impulse <= 0.0);
    const bool splits = kRecords && motion.splitting;
    if (splits) {
      if (!simd::any_lane_set(impulse_now) && !simd::any_lane_set(active & (remaining <= 0.0)))
        return;
      for (int i = 0; i < W; ++i) {
        store_branch_of_lane(i);
        Stream& stream = *streams[i];
        if (simd::lane_value(impulse_now, i) != 0) apply_impulse<kRecords>(motion, stream);
        while (stream.branch.remaining <= 0 && !stream.is_on_main_branch())
          resume_next_branch(stream);
      }
      load_branches();
      return;
    }
    if (!simd::any_lane_set(impulse_now)) return;
    Array<double> ys, vs, untils;
    simd::store(y, ys.at);
    simd::store(v, vs.at);
    simd::store(until_impulse, untils.at);
    for (int i = 0; i < W; ++i) {
      if (!(untils.at[i] <= 0) || simd::lane_value(impulse_now, i) == 0) continue;
      Branch& b = streams[i]->branch;
      b.y = ys.at[i];
      b.v = vs.at[i];
      apply_impulse<kRecords>(motion, *streams[i]);
      vs.at[i] = b.v;
      untils.at[i] = b.until_impulse;
    }
    v = simd::load<Real>(vs.at);
    until_impulse = simd::load<Real>(untils.at);
  }

  template <bool kRecords>
  FPKCHECK_INLINE void advance_streams() {
    // A copy, since the compiler must assume that storing a sum may change the original.
    const Oscillator oscillator = motion.oscillator;
    load_branches();
    for (;;) {
      const Mask active = remaining > 0.0;
      if (!simd::any_lane_set(active)) break;
      // Every iteration advances the time of a lane or ends at y = 0. There the impact reverses the
      // velocity, so the next iteration advances the time. At rest (y = v = 0) the time advances to
      // the next impulse.
      apply_impact<kRecords>(active);
      const BasicFlight<Real> flight(oscillator, {y, v});
      Real span = simd::lanewise_min(
          simd::lanewise_min(flight.max_step(motion.step), until_impulse), remaining);
      span = simd::select_or_zero(active, span);
      BasicState<Real> end = flight.state_at_time(span);
      const Mask impact = (end.y < 0.0) & (y > 0.0);
      if (simd::any_lane_set(impact)) {
        span = simd::select(impact, flight.impact_time(span, end, impact), span);
        const BasicState<Real> at_wall = flight.state_at_time(span);
        end.v = simd::select(impact, at_wall.v, end.v);
        if (kRecords && motion.deposit) beyond_wall = simd::select(impact, at_wall.y, beyond_wall);
        end.y = simd::select(impact, Real{}, end.y);
      }
      if constexpr (kRecords) {
        flights = flights + simd::select_or_zero(active, simd::broadcast<Real>(1.0));
        record_samples(flight, span);
        count_peaks(flight, span, end);
      }
      remaining = remaining - span;
      until_impulse = until_impulse - span;
      y = simd::lanewise_max(end.y, Real{});
      v = end.v;
      apply_lane_events<kRecords>(active);
    }
    for (int i = 0; i < W; ++i) store_branch_of_lane(i);
    if constexpr (kRecords) store_sums();
  }
};

template <int W>
void advance_in_lanes(const MotionParameters& motion, Stream* const* streams) {
  LaneState<W> lanes(motion, streams);
  if (motion.records) {
    lanes.template advance_streams<true>();
  } else {
    lanes.template advance_streams<false>();
  }
}

/// Calls advance_in_lanes() for `width`, which must be one of Widths.
template <int... Widths, class Parameters>
void advance_with_width(const Parameters& motion, Stream* const* streams, int width) {
  ((width == Widths ? advance_in_lanes<Widths>(motion, streams) : void()), ...);
}

}  // namespace
}  // namespace fpkcheck::mcs
