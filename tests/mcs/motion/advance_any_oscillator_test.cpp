#include "mcs/motion/advance_trajectories.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

#include "mcs/motion/taylor_flight.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr double kBetweenSamples = 0.25;
constexpr double kNoImpulse = std::numeric_limits<double>::infinity();

using Kind = SimulatedOscillator::Kind;

/// Group of streams that start at given states and receive no impulses.
struct FreeStreams {
  StreamMotionParameters motion;
  BinFinder y{tests::uniform_edges(-4, 4, 50)}, v{tests::uniform_edges(-5, 5, 50)};
  std::deque<TrajectoryStream> streams{};

  FreeStreams(const SimulatedOscillator& oscillator, const std::vector<OscillatorState>& starts,
              const NoiseKicks& kicks = {})
      : motion{.oscillator = oscillator,
               .kicks = kicks,
               .step = kicks.is_acting() ? 0.3 : 0.9,
               .sampling_interval = kBetweenSamples,
               .y_bins = nullptr,
               .v_bins = nullptr} {
    std::uint32_t number = 0;
    for (const auto& [y_start, v_start] : starts) {
      streams.push_back({.branch = {.y = y_start,
                                    .v = v_start,
                                    .time_to_impulse = kNoImpulse,
                                    .amplitude = 0,
                                    .time_to_sample = kBetweenSamples / 2,
                                    .remaining = 0},
                         .source = ImpulseSource(standard_normal_number_process(), 1, number),
                         .record = TrajectoryStreamStatistics(y, v),
                         .noise = NoiseSource(1, number)});
      if (kicks.is_acting()) {
        streams.back().branch.kick_interval = kicks.longest_interval;
        streams.back().branch.time_to_kick = kicks.longest_interval / 2;
      }
      ++number;
    }
  }

  void advance(double time,
               const simd::SimdVariant& lanes = simd::available_simd_variants().back()) {
    motion.y_bins = &y;
    motion.v_bins = &v;
    std::vector<TrajectoryStream*> pointers;
    for (TrajectoryStream& stream : streams) pointers.push_back(&stream);
    mcs::advance_all_streams(motion, pointers, time, lanes);
  }
  const TrajectoryStream& operator[](std::size_t s) const { return streams[s]; }
};

double acceleration(const SimulatedOscillator& o, double y, double v) {
  double force = 0, damping = 0;
  for (std::size_t n = o.force.size(); n-- > 0;) force = force * y + o.force[n];
  for (std::size_t n = o.damping.size(); n-- > 0;) damping = damping * y + o.damping[n];
  return -force - v * (damping + o.rayleigh * v * v);
}

/// Integrates by the classical Runge-Kutta method.
OscillatorState state_by_runge_kutta(const SimulatedOscillator& o, OscillatorState s, double time) {
  constexpr int kSteps = 20000;
  const double h = time / kSteps;
  for (int n = 0; n < kSteps; ++n) {
    const auto slope = [&](const OscillatorState& at) {
      return OscillatorState{at.v, acceleration(o, at.y, at.v)};
    };
    const auto moved = [&](const OscillatorState& by, double part) {
      return OscillatorState{s.y + part * h * by.y, s.v + part * h * by.v};
    };
    const OscillatorState a = slope(s), b = slope(moved(a, 0.5)), c = slope(moved(b, 0.5)),
                          d = slope(moved(c, 1));
    s = {s.y + h / 6 * (a.y + 2 * b.y + 2 * c.y + d.y),
         s.v + h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
  }
  return s;
}

SimulatedOscillator full_oscillator() {
  return {.force = {0.1, -0.7, 0.2, 0.5, -0.1, 0.3},
          .damping = {-0.1, 0.05, 0.2},
          .rayleigh = 0.1,
          .kind = Kind::full};
}

// Every coefficient contributes: a wrong index or factor changes the first digits.
TEST(AdvanceAnyOscillator, FollowsTheEquationWithAllItsTerms) {
  SimulatedOscillator cubic{
      .force = {0.1, -0.7, 0.2, 0.5, 0, 0}, .damping = {-0.1, 0.05, 0.2}, .kind = Kind::cubic};
  SimulatedOscillator linear{
      .force = {0.3, 1.5, 0, 0, 0, 0}, .damping = {0.2, 0, 0}, .kind = Kind::linear};
  for (const auto& oscillator : {full_oscillator(), cubic, linear}) {
    const std::vector<OscillatorState> starts{{0.3, 0.9}, {-1.5, 0}, {0, 2.5}, {1.2, -1}};
    FreeStreams free(oscillator, starts);
    free.advance(7);
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const OscillatorState exact = state_by_runge_kutta(oscillator, starts[s], 7);
      EXPECT_NEAR(free[s].branch.y, exact.y, 1e-6);
      EXPECT_NEAR(free[s].branch.v, exact.v, 1e-6);
    }
  }
}

// The drift is far below sampling errors: it changes E[v^2] over one decay time only.
TEST(AdvanceAnyOscillator, KeepsTheEnergyOfADoubleWell) {
  const SimulatedOscillator well{.force = {0, -1, 0, 0.5, 0, 0.5}, .kind = Kind::full};
  const auto energy = [](const TrajectoryBranch& b) {
    const double y2 = b.y * b.y;
    return b.v * b.v / 2 - y2 / 2 + y2 * y2 / 8 + y2 * y2 * y2 / 12;
  };
  FreeStreams free(well, {{0.5, 0.1}, {0, 0.01}, {0, 1}, {1, 2}});
  std::vector<double> before;
  for (const TrajectoryStream& stream : free.streams) before.push_back(energy(stream.branch));
  free.advance(1000);
  for (std::size_t s = 0; s < before.size(); ++s) {
    EXPECT_NEAR(energy(free[s].branch), before[s], 5e-6) << s;
  }
}

/// y'' = -(y - 1) with an elastic wall at 0. The motion of amplitude `a` extends slightly behind
/// the wall.
SimulatedOscillator oscillator_with_offset_wall() {
  return {.force = {-1, 1, 0, 0, 0, 0},
          .left = {.exists = true, .position = 0, .restitution = 1, .contact_force = -1}};
}

// These impacts cannot be found from the signs of y at the ends of a flight.
TEST(AdvanceAnyOscillator, FindsImpactsWithinAFlight) {
  const double a = 1.01, u = std::sqrt(a * a - 1);
  const double period = 2 * std::acos(-1 / a);  // from impact to impact
  std::vector<OscillatorState> starts;
  for (int n = 5; n < 14; ++n) {
    starts.push_back({1 + a * std::cos(0.1 * n), -a * std::sin(0.1 * n)});
  }
  FreeStreams free(oscillator_with_offset_wall(), starts);
  free.advance(100 * period);
  for (const TrajectoryStream& stream : free.streams) {
    EXPECT_EQ(stream.record.impacts, 100);
    EXPECT_NEAR(stream.record.left_momentum, 100 * u, 1e-3);
    EXPECT_NEAR(stream.record.left_wall_squared_impact_speeds, 100 * u * u, 1e-3);
  }
  // The mirror image of this motion, with the wall on the other side.
  SimulatedOscillator mirrored{
      .force = {-1, 1, 0, 0, 0, 0},
      .right = {.exists = true, .position = 2, .restitution = 1, .contact_force = -1}};
  FreeStreams right(mirrored, starts);
  right.advance(100 * period);
  for (const TrajectoryStream& stream : right.streams) {
    EXPECT_EQ(stream.record.impacts, 100);
    EXPECT_NEAR(stream.record.right_momentum, 100 * u, 1e-3);
    EXPECT_EQ(stream.record.left_momentum, 0);
  }
}

TEST(AdvanceAnyOscillator, MovesBetweenTwoWalls) {
  const double u = 0.8, r = 0.5, s = 0.75, b = 1.5;
  SimulatedOscillator box{.left = {.exists = true, .position = 0, .restitution = r},
                          .right = {.exists = true, .position = b, .restitution = s}};
  FreeStreams free(box, {{0, u}});
  // The times are b/u to the right, b/(s u) back, b/(r s u) to the right again, and half of the way
  // back.
  free.advance(b / u * (1 + 1 / s + 1 / (r * s) + 0.5 / (r * s * s)));
  const TrajectoryStream& stream = free[0];
  EXPECT_EQ(stream.record.impacts, 3);
  EXPECT_NEAR(stream.branch.y, b / 2, 1e-12);
  EXPECT_NEAR(stream.branch.v, -u * r * s * s, 1e-12);
  EXPECT_NEAR(stream.record.right_momentum, u + u * r * s, 1e-12);
  EXPECT_NEAR(stream.record.left_momentum, u * s, 1e-12);
}

/// Returns the oscillator of a ball on a floor, with the gravitational acceleration 1.
SimulatedOscillator ball_on_floor(double r, double rest_speed) {
  return {.force = {1, 0, 0, 0, 0, 0},
          .left = {.exists = true,
                   .position = 0,
                   .restitution = r,
                   .contact_force = 1,
                   .rest_speed = rest_speed}};
}

// The fall from the height u^2/2 takes the time u, the n-th bounce 2 r^n u: (1 + r)/(1 - r) u in
// all.
TEST(AdvanceAnyOscillator, ComesToRestAfterInfinitelyManyBounces) {
  const double r = 0.6, u = 2, time = 40;
  for (const double rest_speed : {1e-1, 1e-4}) {
    FreeStreams free(ball_on_floor(r, rest_speed), {{u * u / 2, 0}, {u * u / 2, 0}});
    free.advance(time);
    const TrajectoryStreamStatistics& record = free[0].record;
    const double to_rest = u * (1 + r) / (1 - r);
    EXPECT_EQ(free[0].branch.y, 0);
    EXPECT_EQ(free[0].branch.v, 0);
    EXPECT_NEAR(record.rest_left, (time - to_rest) / kBetweenSamples, 1.0);
    EXPECT_NEAR(record.left_momentum, u / (1 - r), 1e-8);
    EXPECT_NEAR(record.left_wall_squared_impact_speeds, u * u / (1 - r * r), 1e-8);
    double in_bins = 0;
    for (const double weight : record.histogram.histogram_cell_weights()) in_bins += weight;
    EXPECT_EQ(in_bins + record.rest_left, record.samples);
  }
  // The mirrored problem is a ball that a force presses against a ceiling.
  SimulatedOscillator up{
      .force = {-1, 0, 0, 0, 0, 0},
      .right = {
          .exists = true, .position = 3, .restitution = r, .contact_force = 1, .rest_speed = 1e-4}};
  FreeStreams above(up, {{3 - u * u / 2, 0}});
  above.advance(time);
  EXPECT_EQ(above[0].branch.y, 3);
  EXPECT_EQ(above[0].record.rest_left, 0);
  EXPECT_NEAR(above[0].record.rest_right, (time - u * (1 + r) / (1 - r)) / kBetweenSamples, 1.0);
}

TEST(AdvanceAnyOscillator, LeavesRestByAnImpulseEitherWay) {
  const double r = 0.6;
  for (const double amplitude : {1.0, -1.0}) {
    FreeStreams free(ball_on_floor(r, 1e-4), {{0, 0}});
    free.advance(1);
    free.streams[0].branch.time_to_impulse = 0.5;
    free.streams[0].branch.amplitude = amplitude;
    free.advance(0.75);
    const double start = amplitude > 0 ? amplitude : r;
    EXPECT_NEAR(free[0].branch.v, start - 0.25, 1e-12);
    EXPECT_NEAR(free[0].branch.y, start * 0.25 - 0.03125, 1e-12);
  }
}

TEST(AdvanceAnyOscillator, GivesTheSameBitsForAnyWidthAndInstructions) {
  SimulatedOscillator walls = full_oscillator();
  walls.left = {
      .exists = true, .position = 0, .restitution = 0.8, .contact_force = 0.1, .rest_speed = 1e-4};
  walls.right = {.exists = true, .position = 1.5, .restitution = 0.7, .contact_force = -1};
  std::vector<OscillatorState> starts;
  for (int s = 0; s < 11; ++s) starts.push_back({0.1 * s, 1 - 0.2 * s});
  const NoiseKicks noise{.diffusion = 0.1,
                         .damping = 0.2,
                         .longest_interval = 0.2,
                         .shortest_interval = 1e-5,
                         .has_lossy_wall = true};
  for (const auto& kicks : {NoiseKicks{}, noise}) {
    FreeStreams reference(walls, starts, kicks);
    reference.advance(100, {simd::InstructionSet::baseline, 1});
    for (const simd::SimdVariant& lanes : simd::available_simd_variants()) {
      SCOPED_TRACE(lanes.width);
      FreeStreams group(walls, starts, kicks);
      group.advance(100, lanes);
      for (std::size_t s = 0; s < starts.size(); ++s) {
        EXPECT_EQ(group[s].branch.y, reference[s].branch.y);
        EXPECT_EQ(group[s].branch.v, reference[s].branch.v);
        EXPECT_EQ(group[s].record.powers, reference[s].record.powers);
        EXPECT_EQ(group[s].record.histogram.histogram_cell_weights(),
                  reference[s].record.histogram.histogram_cell_weights());
        EXPECT_EQ(group[s].record.peaks, reference[s].record.peaks);
        EXPECT_EQ(group[s].record.flights, reference[s].record.flights);
      }
    }
  }
}

TEST(AdvanceAnyOscillator, KicksSoonAfterOneNearAWallThatTakesEnergy) {
  StreamMotionParameters motion{.oscillator = oscillator_with_offset_wall(),
                                .kicks = {.diffusion = 0.5,
                                          .damping = 0,
                                          .longest_interval = 0.2,
                                          .shortest_interval = 1e-6,
                                          .has_lossy_wall = true},
                                .step = 0.3,
                                .sampling_interval = 1,
                                .y_bins = nullptr,
                                .v_bins = nullptr};
  const auto next = [&](double y, double v) {
    return time_to_next_kick(motion, motion.kicks.diffusion, y, v);
  };
  EXPECT_EQ(next(0.01, 0), 0.2);  // an elastic wall
  motion.oscillator.left.restitution = 0.7;
  EXPECT_EQ(next(0, 0), 1e-6);
  EXPECT_EQ(next(0, 2), 0.2);
  EXPECT_EQ(next(5, 0), 0.2);
  // Time scales of the motion under noise: v^2/D and (y^2/D)^(1/3).
  EXPECT_NEAR(next(0, 0.2) / next(0, 0.1), 4, 1e-12);
  EXPECT_NEAR(next(8e-3, 0) / next(1e-3, 0), 4, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::mcs
