#include "mcs/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <utility>

#include "base/input_error.hpp"
#include "base/process/parallel_for.hpp"
#include "mcs/simulation/binary_io.hpp"
#include "mcs/simulation/initial_state_sampler.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::size_t kGroup = 8;  // number of streams that a thread advances together

// Every number is checked, since a checksum can be forged and a simulation from impossible numbers
// may never end.
void require_valid_state(bool holds) {
  if (!holds) throw InputError("impossible numbers in the saved state");
}

bool is_finite(double number) { return std::isfinite(number); }
bool is_finite(std::uint64_t) { return true; }
template <class Numbers>
bool is_finite(const Numbers& numbers) {
  return std::ranges::all_of(numbers, [](const auto& number) { return is_finite(number); });
}

bool is_between_walls(double y, double farthest, const SimulationPlan& plan) {
  const Oscillator& o = plan.oscillator;
  return y >= (o.left.exists ? 0.0 : plan.centre - farthest) &&
         y <= (o.right.exists ? o.right.position : plan.centre + farthest);
}

/// Whether the times until the next kick and until rest are possible.
bool has_valid_times(const Branch& branch, const NoiseKicks& kicks) {
  const double longest_interval = 1.01 * kicks.longest_interval;  // with an allowance for rounding
  const bool waits = kicks.is_present()
                         ? branch.until_kick >= 0 && branch.until_kick <= longest_interval &&
                               branch.kick_interval >= 0 && branch.kick_interval <= longest_interval
                         : branch.until_kick > 0 && branch.kick_interval == 0;
  return waits && branch.time_to_rest >= -1;
}

/// Whether the state of a branch between two rounds is possible: within the range of the motion and
/// of the random numbers.
bool is_valid_state(const Branch& branch, const SimulationPlan& plan) {
  constexpr double kFarthest = 1e4;  // in units of the velocity deviation plus the largest impulse
  // In mean waiting times, or in widths of the law: a larger random number has the probability
  // exp(-1000).
  constexpr double kRarestDraws = 1e3;
  const Excitation& impulses = plan.excitation;
  const double strongest = std::abs(impulses.mean) + kRarestDraws * impulses.width;
  const double v = kFarthest * (plan.velocity_deviation + strongest);
  const double y = v * plan.displacement_deviation / plan.velocity_deviation;
  const double sample = 2 * plan.sampling_interval;
  const auto between = [](double least, double x, double most) { return x >= least && x <= most; };
  return is_between_walls(branch.y, y, plan) && between(-v, branch.v, v) &&
         between(-strongest, branch.amplitude, strongest) &&
         between(0, branch.until_impulse, kRarestDraws * impulses.interval) &&
         between(-sample, branch.until_sample, sample) && between(-sample, branch.remaining, 0) &&
         has_valid_times(branch, plan.kicks);
}

MotionParameters make_motion(const SimulationPlan& plan, const ImportanceSplitting* splitting) {
  // Flights between kicks use a lower order of the Taylor polynomial and therefore need a smaller
  // step limit.
  constexpr double kShorter = 0.35;
  return {.oscillator = plan.oscillator,
          .kicks = plan.kicks,
          .step = plan.step * (plan.kicks.is_present() ? kShorter : 1),
          .sampling_interval = plan.sampling_interval,
          .y_bins = &plan.y_bins,
          .v_bins = &plan.v_bins,
          .splitting = splitting,
          .shift = plan.excitation.shift,
          .deposit = plan.deposit ? &*plan.deposit : nullptr};
}

/// Makes a stream at its initial state.
/// @param sampler null: the folded Gaussian
Stream make_stream(const SimulationPlan& plan, std::uint32_t number,
                   const InitialStateSampler* sampler) {
  ImpulseSource source(plan.excitation, plan.seed, number);
  const State start =
      sampler ? (*sampler)(plan.seed, number)
              : folded_initial_state(source, plan.displacement_deviation, plan.velocity_deviation);
  Impulse first{.waiting = std::numeric_limits<double>::infinity(), .amplitude = 0};
  if (std::isfinite(plan.excitation.interval)) first = source.next_impulse();
  Stream stream{.branch = {.y = start.y,
                           .v = start.v,
                           .until_impulse = first.waiting,
                           .amplitude = first.amplitude,
                           .until_sample = plan.sampling_interval / 2,
                           .remaining = 0},
                .source = source,
                .record = StreamRecord(plan.y_bins, plan.v_bins),
                .noise = NoiseSource(plan.seed, number)};
  if (plan.deposit) stream.record.deposit = DepositedSums(plan.deposit->grid);
  if (plan.kicks.is_present()) {
    // The first kick has a random phase, so that on average the samples are evenly distributed
    // over the interval between kicks.
    const double share =
        uniform_numbers(plan.seed, number, RandomNumberPurpose::start, kBlockSize).third[1];
    stream.branch.kick_interval = plan.kicks.longest_interval;
    stream.branch.until_kick = share * plan.kicks.longest_interval;
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

void Simulation::set_splitting(const ImportanceSplitting& splitting) {
  motion_.splitting = &splitting;
  for (Stream& stream : streams_) stream.record.energies.clear();
}

void Simulation::burn_in() { advance_streams(false, plan_->burn_in); }

void Simulation::run_round() {
  advance_streams(true, plan_->round_time());
  ++rounds_;
}

void Simulation::advance_streams(bool recorded, double time) {
  static const simd::CodeVariant lanes = simd::available_code_variants().back();
  MotionParameters motion = motion_;
  if (!recorded) {
    motion.records = false;
    motion.splitting = nullptr;
    motion.deposit = nullptr;
  }
  const std::size_t groups = (streams_.size() + kGroup - 1) / kGroup;
  base::parallel_for(groups, plan_->threads, [&](std::size_t g) {
    if (!is_stream_of_part(part_, g * kGroup)) return;
    std::vector<Stream*> group;
    for (std::size_t s = g * kGroup; s < std::min((g + 1) * kGroup, streams_.size()); ++s) {
      group.push_back(&streams_[s]);
    }
    advance(motion, group, time, lanes);
  });
}

void Simulation::restrict_to_part(int part, int part_count) {
  part_ = part;
  parts_ = part_count;
}

bool Simulation::is_stream_of_part(int part, std::size_t stream) const {
  return stream / kGroup % static_cast<std::size_t>(parts_) == static_cast<std::size_t>(part);
}

void Simulation::save_stream(std::ostream& out, const Stream& stream) const {
  write_binary(out, stream.branch);
  write_binary(out, stream.source.number());
  write_binary(out, stream.noise.number());
  for_each_sum(stream.record, [&](const auto& sum) { write_binary(out, sum); });
}

void Simulation::load_stream(std::istream& in, Stream& stream) const {
  std::uint64_t number = 0;
  read_binary(in, stream.branch);
  const int threshold_count = motion_.splitting ? motion_.splitting->threshold_count() : 0;
  require_valid_state(is_valid_state(stream.branch, *plan_) && stream.branch.energy_level >= 0 &&
                      stream.branch.energy_level <= threshold_count &&
                      stream.branch.floor_level >= 0 &&
                      stream.branch.floor_level <= threshold_count);
  read_binary(in, number);
  stream.source.continue_from(number);
  read_binary(in, number);
  stream.noise.continue_from(number);
  for_each_sum(stream.record, [&](auto& sum) {
    read_binary(in, sum);
    require_valid_state(is_finite(sum));
  });
}

void Simulation::save(std::ostream& out) const {
  write_binary(out, rounds_);
  for (const Stream& stream : streams_) save_stream(out, stream);
}

void Simulation::load(std::istream& in) {
  read_binary(in, rounds_);
  // No simulation reaches this number of rounds: a file with more rounds is manipulated.
  constexpr std::uint64_t kMostRounds = std::uint64_t{1} << 50;
  require_valid_state(rounds_ <= kMostRounds);
  for (Stream& stream : streams_) load_stream(in, stream);
  require_valid_state(static_cast<bool>(in) && in.peek() == std::istream::traits_type::eof());
}

void Simulation::save_part(std::ostream& out) const {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (is_stream_of_part(part_, s)) save_stream(out, streams_[s]);
  }
}

void Simulation::load_part(std::istream& in, int part) {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (is_stream_of_part(part, s)) load_stream(in, streams_[s]);
  }
  require_valid_state(static_cast<bool>(in) && in.peek() == std::istream::traits_type::eof());
}

}  // namespace fpkcheck::mcs
