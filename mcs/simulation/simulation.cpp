#include "mcs/simulation/simulation.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "mcs/simulation/initial_state_sampler.hpp"
#include "numerics/roots/bracketed_root.hpp"
#include "numerics/statistics.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::size_t kGroup = 8;  // number of streams that a thread advances together

StreamMotionParameters make_motion(const SimulationPlan& plan,
                                   const ImportanceSplitting* splitting) {
  // Ratio of the step limit of flights between noise kicks to the step limit of other flights,
  // whose Taylor polynomials have a higher order.
  constexpr double kShorter = 0.35;
  const bool has_lower_order =
      plan.kicks.is_acting() && plan.oscillator.kind != SimulatedOscillator::Kind::formula;
  return {.oscillator = plan.oscillator,
          .kicks = plan.kicks,
          .step = plan.step * (has_lower_order ? kShorter : 1),
          .sampling_interval = plan.sampling_interval,
          .y_bins = &plan.y_bins,
          .v_bins = &plan.v_bins,
          .splitting = splitting,
          .shift = plan.excitation.shift,
          .deposit = plan.deposit ? &*plan.deposit : nullptr};
}

/// Returns a trajectory stream in its initial state.
/// @param sampler sampler of the initial state; null for an initial state from the folded Gaussian
TrajectoryStream make_stream(const SimulationPlan& plan, std::uint32_t number,
                             const InitialStateSampler* sampler) {
  ImpulseSource source(plan.excitation, plan.seed, number);
  const OscillatorState start =
      sampler ? (*sampler)(plan.seed, number)
              : folded_initial_state(source, plan.displacement_deviation, plan.velocity_deviation);
  Impulse first{.waiting_time = std::numeric_limits<double>::infinity(), .amplitude = 0};
  if (std::isfinite(plan.excitation.interval)) first = source.next_impulse();
  TrajectoryStream stream{.branch = {.y = start.y,
                                     .v = start.v,
                                     .time_to_impulse = first.waiting_time,
                                     .amplitude = first.amplitude,
                                     .time_to_sample = plan.sampling_interval / 2,
                                     .remaining = 0},
                          .source = source,
                          .record = TrajectoryStreamStatistics(plan.y_bins, plan.v_bins),
                          .noise = NoiseSource(plan.seed, number)};
  if (plan.deposit) stream.record.deposit = DepositedSampleSums(plan.deposit->grid);
  if (plan.kicks.is_acting()) {
    // The first noise kick has a random phase, so that the sampling times are on average evenly
    // distributed over the interval between noise kicks.
    const double share =
        uniform_random_numbers(plan.seed, number, RandomNumberPurpose::start, kImpulsesPerBlock)
            .third[1];
    stream.branch.kick_interval = plan.kicks.longest_interval;
    stream.branch.time_to_kick = share * plan.kicks.longest_interval;
  }
  return stream;
}

}  // namespace

Simulation::Simulation(const problem::Problem& problem, const SimulationPlan& plan,
                       const ImportanceSplitting* splitting)
    : plan_(&plan), motion_(make_motion(plan, splitting)) {
  std::optional<InitialStateSampler> sampler;
  if (!plan.oscillator.is_duffing_at_wall()) sampler.emplace(problem);
  for (int s = 0; s < plan.streams; ++s) {
    streams_.push_back(
        make_stream(plan, static_cast<std::uint32_t>(s), sampler ? &*sampler : nullptr));
  }
}

void Simulation::set_importance_splitting(const ImportanceSplitting& splitting) {
  motion_.splitting = &splitting;
  for (TrajectoryStream& stream : streams_) stream.record.energies.clear();
}

void Simulation::enable_displacement_recording() {
  assert(motion_.splitting == nullptr);
  motion_.records_displacement_series = true;
}

void Simulation::enable_state_recording() {
  assert(motion_.splitting == nullptr && motion_.kicks.factor == nullptr);
  motion_.keeps_states = true;
}

void Simulation::restart_trajectory_stream(std::size_t stream, double y, double v) {
  TrajectoryBranch& branch = streams_[stream].branch;
  branch.y = y;
  branch.v = v;
  branch.time_to_rest = -1;
  branch.time_to_sample = plan_->sampling_interval / 2;
  if (std::isfinite(plan_->excitation.interval)) {
    const Impulse next = streams_[stream].source.next_impulse();
    branch.time_to_impulse = next.waiting_time;
    branch.amplitude = next.amplitude;
    if (plan_->excitation.arrivals == ImpulseProcess::Arrivals::even) {
      // Evenly spaced kicks have a random phase, whose uniform random number is the distribution
      // function at an unused Gaussian amplitude.
      const Impulse other = streams_[stream].source.next_impulse();
      const double deviations =
          (other.amplitude - plan_->excitation.mean) / plan_->excitation.width;
      branch.time_to_impulse *= numerics::normal_probability(deviations);
    }
  }
}

void Simulation::continue_branch(std::size_t stream, const TrajectoryBranch& branch) {
  TrajectoryStream& own = streams_[stream];
  own.branch = branch;
  if (!std::isfinite(plan_->excitation.interval)) return;
  const Impulse next = own.source.next_impulse();
  own.branch.amplitude = next.amplitude;
  if (plan_->excitation.arrivals == ImpulseProcess::Arrivals::poisson) {
    own.branch.time_to_impulse = next.waiting_time;
  }
}

// Returns the contact forces on the left wall and on the right wall at the time t.
std::array<double, 2> Simulation::contact_forces_at_time(double t) const {
  const double force = plan_->time.external_force(t);
  return {plan_->oscillator.left.contact_force - force,
          plan_->oscillator.right.contact_force + force};
}

// Sets the contact forces to the values at the time t, and ends the state of rest in all trajectory
// streams. A mass that the changed contact force presses on the wall comes to rest again
// immediately.
void Simulation::set_contact_forces(double t) {
  const auto [left, right] = contact_forces_at_time(t);
  set_contact_force(plan_->oscillator, left, motion_.oscillator.left);
  set_contact_force(plan_->oscillator, right, motion_.oscillator.right);
  for (TrajectoryStream& stream : streams_) stream.branch.time_to_rest = -1;
}

void Simulation::advance_streams_between_times(double from, double to) {
  motion_.time_dependence = plan_->time.is_acting() ? &plan_->time : nullptr;
  const auto advance_to = [&](double end) {
    motion_.end_time = end;
    advance_trajectory_streams(false, end - from);
    from = end;
  };
  const SimulatedOscillator& oscillator = plan_->oscillator;
  const std::array has_wall{oscillator.left.exists, oscillator.right.exists};
  if (!plan_->time.has_external_force() || !(has_wall[0] || has_wall[1])) return advance_to(to);
  // While a force presses the mass on a wall, the contact force is taken as constant on intervals
  // of half a radian, since the contact force only determines the end of the bounces below
  // SimulatedWall::rest_speed. Intervals of constant contact force also end at zeros of the contact
  // force, which are searched in steps of 1/10 radian.
  constexpr double kSearchStep = 0.1, kPressedInterval = 0.5, kShortest = 1e-6;
  while (from < to) {
    double end = to;
    const double earliest_end = from + kShortest / oscillator.frequency;
    for (std::size_t wall = 0; wall < has_wall.size(); ++wall) {
      if (!has_wall[wall]) continue;
      const auto force = [&](double t) { return contact_forces_at_time(t)[wall]; };
      if (force(earliest_end) > 0) {
        end = std::min(end, from + kPressedInterval / oscillator.frequency);
      }
      for (double low = earliest_end; low < end;) {
        const double high = std::min(end, low + kSearchStep / oscillator.frequency);
        if (force(low) * force(high) < 0) end = numerics::bracketed_root(force, low, high);
        low = high;
      }
    }
    end = std::min(to, std::max(end, earliest_end));
    set_contact_forces((from + end) / 2);
    advance_to(end);
  }
}

void Simulation::run_burn_in() { advance_trajectory_streams(false, plan_->burn_in); }

void Simulation::simulate_and_sample_one_round() {
  advance_trajectory_streams(true, plan_->simulated_time_per_round());
  ++rounds_;
}

void Simulation::advance_trajectory_streams(bool recorded, double time) {
  static const simd::SimdVariant lanes = simd::available_simd_variants().back();
  StreamMotionParameters motion = motion_;
  if (!recorded) {
    motion.records = false;
    motion.keeps_states = false;
    motion.splitting = nullptr;
    motion.deposit = nullptr;
  }
  const std::size_t groups = (streams_.size() + kGroup - 1) / kGroup;
  base::parallel_for(groups, plan_->threads, [&](std::size_t g) {
    if (!is_stream_of_process(part_, g * kGroup)) return;
    std::vector<TrajectoryStream*> group;
    for (std::size_t s = g * kGroup; s < std::min((g + 1) * kGroup, streams_.size()); ++s) {
      group.push_back(&streams_[s]);
    }
    advance_all_streams(motion, group, time, lanes);
  });
}

void Simulation::keep_streams_of_process(int part, int part_count) {
  part_ = part;
  parts_ = part_count;
}

bool Simulation::is_stream_of_process(int part, std::size_t stream) const {
  return stream / kGroup % static_cast<std::size_t>(parts_) == static_cast<std::size_t>(part);
}

}  // namespace fpkcheck::mcs
