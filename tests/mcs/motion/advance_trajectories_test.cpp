#include "mcs/motion/advance_trajectories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "mcs/scalar_trajectory.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr double kStep = 0.9;
constexpr double kInterval = 0.25;

struct Group {
  SimulatedOscillator oscillator;
  BinFinder y{tests::uniform_edges(0, 4, 50)}, v{tests::uniform_edges(-5, 5, 50)};
  std::deque<TrajectoryStream> streams{};

  explicit Group(const problem::Problem& problem, int count = 11)
      : oscillator(tests::oscillator_of(problem)) {
    for (int s = 0; s < count; ++s) {
      ImpulseSource source(problem.impulses, 21, static_cast<std::uint32_t>(s));
      const Impulse first = source.next_impulse();
      streams.push_back({.branch = {.y = 0.1 * s,
                                    .v = 1 - 0.2 * s,
                                    .time_to_impulse = first.waiting_time,
                                    .amplitude = first.amplitude,
                                    .time_to_sample = kInterval / 2,
                                    .remaining = 0},
                         .source = source,
                         .record = TrajectoryStreamStatistics(y, v)});
    }
  }

  void advance(double time, const simd::SimdVariant& lanes) {
    std::vector<TrajectoryStream*> pointers;
    for (TrajectoryStream& stream : streams) pointers.push_back(&stream);
    mcs::advance_all_streams({.oscillator = oscillator,
                              .step = kStep,
                              .sampling_interval = kInterval,
                              .y_bins = &y,
                              .v_bins = &v},
                             pointers, time, lanes);
  }
};

/// 11 streams form full SIMD groups and leave single streams, for every number of lanes.
std::vector<Group> stream_groups_of_all_kinds() {
  std::vector<Group> groups;
  for (const auto& problem :
       {tests::paper_case(4), tests::make_problem({.restitution = 0.3, .law = "laplace"})}) {
    groups.emplace_back(problem);
  }
  groups.emplace_back(tests::make_problem({.law = "uniform"}));
  return groups;
}

TEST(Advance, GivesTheSameBitsForAnyWidthAndInstructions) {
  for (const Group& start : stream_groups_of_all_kinds()) {
    Group reference(start);
    reference.advance(300, {simd::InstructionSet::baseline, 1});
    for (const simd::SimdVariant& lanes : simd::available_simd_variants()) {
      SCOPED_TRACE(lanes.width);
      Group group(start);
      group.advance(300, lanes);
      for (std::size_t s = 0; s < group.streams.size(); ++s) {
        const TrajectoryStream &a = reference.streams[s], &b = group.streams[s];
        EXPECT_EQ(a.branch.y, b.branch.y);
        EXPECT_EQ(a.branch.v, b.branch.v);
        EXPECT_EQ(a.record.powers, b.record.powers);
        EXPECT_EQ(a.record.histogram.histogram_cell_weights(),
                  b.record.histogram.histogram_cell_weights());
        EXPECT_EQ(a.record.peaks, b.record.peaks);
        EXPECT_EQ(a.record.troughs, b.record.troughs);
        EXPECT_EQ(a.record.work, b.record.work);
        EXPECT_EQ(a.record.impacts, b.record.impacts);
        EXPECT_EQ(a.record.left_momentum, b.record.left_momentum);
        EXPECT_EQ(a.record.left_wall_squared_impact_speeds,
                  b.record.left_wall_squared_impact_speeds);
        EXPECT_EQ(a.record.flights, b.record.flights);
      }
    }
  }
}

/// Computes the sums of a TrajectoryStreamStatistics from the scalar trajectory.
struct Tally {
  double time_to_sample = kInterval / 2;
  double samples = 0, yyv = 0, impacts = 0, impact_speed = 0, impact_energy = 0, work = 0;
  void on_flight(const tests::Flight& flight, double duration) {
    for (; time_to_sample < duration; time_to_sample += kInterval) {
      const OscillatorState at = flight.state_at_time(time_to_sample);
      yyv += at.y * at.y * at.v;
      ++samples;
    }
    time_to_sample -= duration;
  }
  void on_impact(double v) {
    ++impacts;
    impact_speed += std::abs(v);
    impact_energy += v * v;
  }
  void on_impulse(double v, double amplitude) { work += amplitude * (v + amplitude / 2); }
};

TEST(Advance, AgreesWithTheScalarTrajectory) {
  const auto problem = tests::make_problem({.cubic = 1, .restitution = 0.6, .rate = 3});
  Group group(problem);
  constexpr double kTime = 30;
  group.advance(kTime, simd::available_simd_variants().back());
  for (std::size_t s = 0; s < group.streams.size(); ++s) {
    const auto n = static_cast<double>(s);
    tests::Trajectory trajectory(group.oscillator,
                                 ImpulseSource(problem.impulses, 21, static_cast<std::uint32_t>(s)),
                                 {0.1 * n, 1 - 0.2 * n}, kStep);
    Tally tally;
    trajectory.advance(kTime, tally);
    const TrajectoryStream& stream = group.streams[s];
    EXPECT_NEAR(stream.branch.y, trajectory.state().y, 1e-9);
    EXPECT_NEAR(stream.branch.v, trajectory.state().v, 1e-9);
    EXPECT_NEAR(stream.record.powers[6], tally.yyv, 1e-9);  // y^2 v
    EXPECT_EQ(stream.record.samples, tally.samples);
    EXPECT_EQ(stream.record.impacts, tally.impacts);
    EXPECT_NEAR(stream.record.left_momentum, tally.impact_speed, 1e-9);
    EXPECT_NEAR(stream.record.left_wall_squared_impact_speeds, tally.impact_energy, 1e-9);
    EXPECT_NEAR(stream.record.work, tally.work, 1e-9);
  }
}

double sum_of_elements(const std::vector<double>& sums) {
  double sum = 0;
  for (const double x : sums) sum += x;
  return sum;
}

// Between two impacts there is one maximum more than minima.
TEST(Advance, CountsOneMaximumMoreThanMinimaFromImpactToImpact) {
  Group group(tests::paper_case(1));
  group.advance(3000, simd::available_simd_variants().back());
  for (const TrajectoryStream& stream : group.streams) {
    EXPECT_GT(sum_of_elements(stream.record.troughs), 10);
    EXPECT_NEAR(sum_of_elements(stream.record.peaks) - sum_of_elements(stream.record.troughs),
                stream.record.impacts, 1);
    EXPECT_EQ(sum_of_elements(stream.record.histogram.histogram_cell_weights()),
              stream.record.samples);
    EXPECT_EQ(stream.record.samples, 12000);
  }
}

TEST(Advance, EndsAfterABoundedNumberOfFlightsAtStrongLossesAndRest) {
  for (const double r : {0.05, 1e-8}) {
    for (const double mean : {-0.9, 0.0, 0.9}) {
      for (const double rate : {50.0, 1.0, 1e-3}) {
        // The mean is a fraction of the root of E[Y^2] = 0.1.
        Group group(tests::make_problem({.restitution = r,
                                         .rate = rate,
                                         .intensity = 0.1 * rate,
                                         .mean = mean * std::sqrt(0.1)}));
        const double time = tests::part_unless_thorough(40, 200) / std::min(rate, 1.0);
        group.advance(time, simd::available_simd_variants().back());
        for (const TrajectoryStream& stream : group.streams) {
          const auto impulses = static_cast<double>(stream.record.impulses);
          EXPECT_LE(stream.record.impacts, time * 2 + impulses);
          EXPECT_LT(static_cast<double>(stream.record.flights), 10 * time + 4 * impulses);
          EXPECT_GE(stream.branch.y, 0);
          EXPECT_TRUE(std::isfinite(stream.branch.v));
        }
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
