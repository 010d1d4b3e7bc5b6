#include "mcs/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <utility>

#include "base/input_error.hpp"
#include "mcs/motion/start.hpp"
#include "mcs/simulation/general_start.hpp"
#include "mcs/simulation/saved_numbers.hpp"
#include "mcs/simulation/workers.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::size_t kGroup = 8;  // streams per task of a thread

// A forged checksum is no protection, and a simulation from impossible numbers may never end.
void require_possible(bool holds) {
  if (!holds) throw InputError("impossible numbers in the saved state");
}

bool is_finite(double number) { return std::isfinite(number); }
bool is_finite(std::uint64_t) { return true; }
template <class Numbers>
bool is_finite(const Numbers& numbers) {
  return std::ranges::all_of(numbers, [](const auto& number) { return is_finite(number); });
}

bool is_between_walls(double y, double farthest, const Plan& plan) {
  if (!plan.general) return y >= 0 && y <= farthest;
  const GeneralOscillator& o = plan.general->oscillator;
  const double centre = plan.general->scales.centre;
  return y >= (o.left.stands ? 0.0 : centre - farthest) &&
         y <= (o.right.stands ? o.right.position : centre + farthest);
}

bool is_possible(const GeneralBranch& branch, const GeneralKicks& kicks) {
  const double longest = 1.01 * kicks.longest;  // with an allowance for rounding
  const bool waits = kicks.present()
                         ? branch.until_kick >= 0 && branch.until_kick <= longest &&
                               branch.kick_interval >= 0 && branch.kick_interval <= longest
                         : branch.until_kick > 0 && branch.kick_interval == 0;
  return waits && branch.bouncing >= -1;
}

/// Whether a branch between two rounds is within the range of the motion and of the random numbers.
bool is_possible(const Branch& branch, const Plan& plan) {
  constexpr double kFarthest = 1e4;  // in units of the deviation plus the largest impulse
  // In mean waiting times, or widths of the law: such a draw has the probability exp(-1000).
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
         between(-sample, branch.until_sample, sample) && between(-sample, branch.remaining, 0);
}

/// A stream at its initial state.
/// @param source of the impulses after the first one
Stream stream_at(const State& start, const Impulse& first, const ImpulseSource& source,
                 const Plan& plan) {
  return {.branch = {.y = start.y,
                     .v = start.v,
                     .until_impulse = first.waiting,
                     .amplitude = first.amplitude,
                     .until_sample = plan.sampling_interval / 2,
                     .remaining = 0},
          .source = source,
          .record = StreamRecord(plan.y_bins, plan.v_bins)};
}

}  // namespace

Simulation::Simulation(const problem::Problem& problem, const Plan& plan,
                       const Splitting* splitting)
    : plan_(&plan) {
  if (plan.general) {
    begin_any(problem, splitting);
    return;
  }
  motion_ = Motion{.oscillator = Oscillator(problem.system),
                   .step = plan.step,
                   .sampling_interval = plan.sampling_interval,
                   .y_bins = &plan.y_bins,
                   .v_bins = &plan.v_bins,
                   .splitting = splitting,
                   .shift = plan.excitation.shift,
                   .deposit = plan.deposit ? &*plan.deposit : nullptr};
  for (int s = 0; s < plan.streams; ++s) {
    ImpulseSource source(plan.excitation, plan.seed, static_cast<std::uint32_t>(s));
    const State start = folded_start(source, plan.displacement_deviation, plan.velocity_deviation);
    const Impulse first = source.next();
    streams_.push_back(stream_at(start, first, source, plan));
    if (plan.deposit) streams_.back().record.deposit = Deposit(plan.deposit->grid);
  }
}

void Simulation::begin_any(const problem::Problem& problem, const Splitting* splitting) {
  const Plan& plan = *plan_;
  const GeneralPlan& general = *plan.general;
  // Flights between kicks use a lower order, so their steps are shorter.
  constexpr double kShorter = 0.35;
  general_ = GeneralMotion{.oscillator = general.oscillator,
                           .kicks = general.kicks,
                           .step = plan.step * (general.kicks.present() ? kShorter : 1),
                           .sampling_interval = plan.sampling_interval,
                           .y_bins = &plan.y_bins,
                           .v_bins = &plan.v_bins,
                           .records = true,
                           .splitting = splitting};
  const GeneralStart start_of(problem);
  for (int s = 0; s < plan.streams; ++s) {
    const auto stream = static_cast<std::uint32_t>(s);
    ImpulseSource source(plan.excitation, plan.seed, stream);
    const State start = start_of(plan.seed, stream);
    Impulse first{.waiting = std::numeric_limits<double>::infinity(), .amplitude = 0};
    if (std::isfinite(plan.excitation.interval)) first = source.next();
    Stream made = stream_at(start, first, source, plan);
    made.noise = NoiseSource(plan.seed, stream);
    made.record.general.emplace();
    if (general.kicks.present()) {
      // A random phase of the kicks: on average the samples are evenly distributed over the
      // interval.
      const double share = uniforms(plan.seed, stream, Purpose::start, kBlock).third[1];
      made.general.kick_interval = general.kicks.longest;
      made.general.until_kick = share * general.kicks.longest;
    }
    streams_.push_back(std::move(made));
  }
}

void Simulation::split_by(const Splitting& splitting) {
  (general_ ? general_->splitting : motion_->splitting) = &splitting;
  for (Stream& stream : streams_) stream.record.energies.clear();
}

void Simulation::burn_in() { move(false, plan_->burn_in); }

void Simulation::round() {
  move(true, plan_->round_time());
  ++rounds_;
}

void Simulation::move(bool recorded, double time) {
  static const simd::LaneSet lanes = simd::available_lanes().back();
  if (general_) {
    GeneralMotion motion = *general_;
    motion.records = recorded;
    return move([&](std::span<Stream* const> group) { advance(motion, group, time, lanes); });
  }
  Motion motion = *motion_;
  if (!recorded) {
    motion.records = false;
    motion.splitting = nullptr;
    motion.deposit = nullptr;
  }
  move([&](std::span<Stream* const> group) { advance(motion, group, time, lanes); });
}

void Simulation::move(const std::function<void(std::span<Stream* const>)>& move) {
  const std::size_t groups = (streams_.size() + kGroup - 1) / kGroup;
  share_work(plan_->threads, groups, [&](std::size_t g) {
    if (!is_of(part_, g * kGroup)) return;
    std::vector<Stream*> group;
    for (std::size_t s = g * kGroup; s < std::min((g + 1) * kGroup, streams_.size()); ++s) {
      group.push_back(&streams_[s]);
    }
    move(group);
  });
}

void Simulation::share(int part, int parts) {
  part_ = part;
  parts_ = parts;
}

bool Simulation::is_of(int part, std::size_t stream) const {
  return stream / kGroup % static_cast<std::size_t>(parts_) == static_cast<std::size_t>(part);
}

void Simulation::save_stream(std::ostream& out, const Stream& stream) const {
  put(out, stream.branch);
  put(out, stream.source.number());
  if (general_) {
    put(out, stream.general);
    put(out, stream.noise.number());
  }
  for_each_sum(stream.record, [&](const auto& sum) { put(out, sum); });
}

void Simulation::load_stream(std::istream& in, Stream& stream) const {
  std::uint64_t number = 0;
  get(in, stream.branch);
  const Splitting* splitting = general_ ? general_->splitting : motion_->splitting;
  const int levels = splitting ? splitting->levels() : 0;
  require_possible(is_possible(stream.branch, *plan_) && stream.branch.level >= 0 &&
                   stream.branch.level <= levels && stream.branch.floor >= 0 &&
                   stream.branch.floor <= levels);
  get(in, number);
  stream.source.continue_from(number);
  if (general_) {
    get(in, stream.general);
    require_possible(is_possible(stream.general, plan_->general->kicks));
    get(in, number);
    stream.noise.continue_from(number);
  }
  for_each_sum(stream.record, [&](auto& sum) {
    get(in, sum);
    require_possible(is_finite(sum));
  });
}

void Simulation::save(std::ostream& out) const {
  put(out, rounds_);
  for (const Stream& stream : streams_) save_stream(out, stream);
}

void Simulation::load(std::istream& in) {
  get(in, rounds_);
  // Only a manipulated file has more rounds.
  constexpr std::uint64_t kMostRounds = std::uint64_t{1} << 50;
  require_possible(rounds_ <= kMostRounds);
  for (Stream& stream : streams_) load_stream(in, stream);
  require_possible(static_cast<bool>(in) && in.peek() == std::istream::traits_type::eof());
}

void Simulation::save_part(std::ostream& out) const {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (is_of(part_, s)) save_stream(out, streams_[s]);
  }
}

void Simulation::load_part(std::istream& in, int part) {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (is_of(part, s)) load_stream(in, streams_[s]);
  }
  require_possible(static_cast<bool>(in) && in.peek() == std::istream::traits_type::eof());
}

}  // namespace fpkcheck::mcs
