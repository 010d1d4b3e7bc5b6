#include "mcs/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <istream>
#include <ostream>
#include <type_traits>
#include <vector>

#include "base/input_error.hpp"

namespace fpkcheck::mcs {

namespace {

/// Writes a number in the native binary form, for files that are read on a machine of the same
/// type.
template <class Number>
requires std::is_trivially_copyable_v<Number>
void write_binary(std::ostream& out, const Number& number) {
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class Number>
requires std::is_trivially_copyable_v<Number>
void read_binary(std::istream& in, Number& number) {
  in.read(reinterpret_cast<char*>(&number), sizeof number);
}

// Largest accepted size of a list in a checkpoint, for lists of unknown expected size
constexpr std::uint64_t kLargestFreeSize = 100000;

void require_valid_list(bool holds) {
  if (!holds) throw InputError("wrong number of entries");
}

/// Writes a list of numbers in binary form. Successive zeros in the list are stored as the number
/// of zeros, since most lists of statistics consist mainly of zeros.
void write_binary(std::ostream& out, const std::vector<double>& numbers) {
  write_binary(out, std::uint64_t{numbers.size()});
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t zeros = k;
    while (zeros < numbers.size() && numbers[zeros] == 0) ++zeros;
    std::size_t end = zeros;
    while (end < numbers.size() && numbers[end] != 0) ++end;
    write_binary(out, std::uint64_t{zeros - k});
    write_binary(out, std::uint64_t{end - zeros});
    for (std::size_t i = zeros; i < end; ++i) write_binary(out, numbers[i]);
    k = end;
  }
}

/// Reads a list of numbers that write_binary() wrote.
/// @param numbers list of the expected size; an empty list accepts any size
/// @throws InputError if the list in the file has an unexpected size or an invalid format
void read_binary(std::istream& in, std::vector<double>& numbers) {
  std::uint64_t size = 0;
  read_binary(in, size);
  require_valid_list(in && (numbers.empty() ? size <= kLargestFreeSize : size == numbers.size()));
  numbers.assign(size, 0.0);
  for (std::uint64_t k = 0; k < size;) {
    std::uint64_t zeros = 0, others = 0;
    read_binary(in, zeros);
    read_binary(in, others);
    require_valid_list(in && zeros <= size - k && others <= size - k - zeros && zeros + others > 0);
    k += zeros;
    for (const std::uint64_t end = k + others; k < end; ++k) read_binary(in, numbers[k]);
  }
  require_valid_list(static_cast<bool>(in));
}

// Every number of a saved simulation state is checked, since a simulation from impossible numbers
// may never end, and a checksum can be forged.
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
  const SimulatedOscillator& o = plan.oscillator;
  return y >= (o.left.exists ? 0.0 : plan.centre - farthest) &&
         y <= (o.right.exists ? o.right.position : plan.centre + farthest);
}

bool has_valid_times(const TrajectoryBranch& branch, const NoiseKicks& kicks) {
  // Upper limit of the interval between noise kicks, with an allowance for rounding
  const double longest_interval = 1.01 * kicks.longest_interval;
  const bool waits = kicks.is_acting()
                         ? branch.time_to_kick >= 0 && branch.time_to_kick <= longest_interval &&
                               branch.kick_interval >= 0 && branch.kick_interval <= longest_interval
                         : branch.time_to_kick > 0 && branch.kick_interval == 0;
  return waits && branch.time_to_rest >= -1;
}

/// Returns whether the state of a branch is within the range of the motion and of the random
/// numbers.
bool is_valid_state(const TrajectoryBranch& branch, const SimulationPlan& plan) {
  // Largest valid saved speed, in units of the velocity deviation plus the largest impulse
  constexpr double kFarthest = 1e4;
  // Largest valid waiting time in a saved state, in mean waiting times, and largest valid
  // amplitude, in widths of the amplitude law. Random waiting times and amplitudes above
  // kRarestDraws have a probability of at most about exp(-1000).
  constexpr double kRarestDraws = 1e3;
  const ImpulseProcess& impulses = plan.excitation;
  const double strongest = std::abs(impulses.mean) + kRarestDraws * impulses.width;
  const double v = kFarthest * (plan.velocity_deviation + strongest);
  const double y = v * plan.displacement_deviation / plan.velocity_deviation;
  const double sample = 2 * plan.sampling_interval;
  const auto between = [](double least, double x, double most) { return x >= least && x <= most; };
  return is_between_walls(branch.y, y, plan) && between(-v, branch.v, v) &&
         between(-strongest, branch.amplitude, strongest) &&
         between(0, branch.time_to_impulse, kRarestDraws * impulses.interval) &&
         between(-sample, branch.time_to_sample, sample) && between(-sample, branch.remaining, 0) &&
         has_valid_times(branch, plan.kicks);
}

}  // namespace

void Simulation::save_stream(std::ostream& out, const TrajectoryStream& stream) const {
  write_binary(out, stream.branch);
  write_binary(out, stream.source.drawn_impulse_count());
  write_binary(out, stream.noise.drawn_number_count());
  for_each_statistic(stream.record, [&](const auto& sum) { write_binary(out, sum); });
}

void Simulation::load_stream(std::istream& in, TrajectoryStream& stream) const {
  std::uint64_t number = 0;
  read_binary(in, stream.branch);
  const int threshold_count = motion_.splitting ? motion_.splitting->threshold_count() : 0;
  require_valid_state(is_valid_state(stream.branch, *plan_) && stream.branch.energy_level >= 0 &&
                      stream.branch.energy_level <= threshold_count &&
                      stream.branch.floor_level >= 0 &&
                      stream.branch.floor_level <= threshold_count);
  read_binary(in, number);
  stream.source.seek_to_impulse(number);
  read_binary(in, number);
  stream.noise.seek_to_number(number);
  for_each_statistic(stream.record, [&](auto& sum) {
    read_binary(in, sum);
    require_valid_state(is_finite(sum));
  });
}

void Simulation::save_state(std::ostream& out) const {
  write_binary(out, rounds_);
  for (const TrajectoryStream& stream : streams_) save_stream(out, stream);
}

void Simulation::load_state(std::istream& in) {
  read_binary(in, rounds_);
  // Number of rounds that no simulation reaches; a checkpoint file with more rounds than
  // kMostRounds is manipulated.
  constexpr std::uint64_t kMostRounds = std::uint64_t{1} << 50;
  require_valid_state(rounds_ <= kMostRounds);
  for (TrajectoryStream& stream : streams_) load_stream(in, stream);
  require_valid_state(static_cast<bool>(in) && in.peek() == std::istream::traits_type::eof());
}

void Simulation::save_streams_of_this_process(std::ostream& out) const {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (is_stream_of_process(part_, s)) save_stream(out, streams_[s]);
  }
}

void Simulation::load_streams_of_process(std::istream& in, int part) {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (is_stream_of_process(part, s)) load_stream(in, streams_[s]);
  }
  require_valid_state(static_cast<bool>(in) && in.peek() == std::istream::traits_type::eof());
}

}  // namespace fpkcheck::mcs
